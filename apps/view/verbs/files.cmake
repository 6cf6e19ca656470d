# The verbs of soms-view: their options, and what they do.
set(SOMS_VIEW_HEADERS
  render.h
  render_camera.h
  render_scene.h
  time_frames.h
  verbs.h
  view.h
)
set(SOMS_VIEW_SOURCES
  render.cpp
  render_camera.cpp
  render_scene.cpp
  time_frames.cpp
  verbs.cpp
  view.cpp
)
