# State, actions, camera modes, gizmo and panels: no window, no OpenGL. Dear ImGui's headers are a
# system's, and tests that click its widgets need them too.
set(SOMS_VIEW_HEADERS
  action.h
  camera_moves.h
  detail.h
  frame_times.h
  gizmo.h
  help.h
  imgui_input.h
  input_event.h
  keys.h
  panels.h
  playback.h
  session.h
  style.h
  subject.h
  view_state.h
  widgets.h
)
set(SOMS_VIEW_SOURCES
  action.cpp
  camera_moves.cpp
  detail.cpp
  frame_times.cpp
  gizmo.cpp
  help.cpp
  keys.cpp
  panels.cpp
  playback.cpp
  session.cpp
  style.cpp
  view_state.cpp
  widgets.cpp
)
target_include_directories(soms_view SYSTEM PUBLIC ${IMGUI_INCLUDE_DIRS})
