# The window: GLFW, the back ends of Dear ImGui, and the loop; and the scene as the controls see it.
set(SOMS_VIEW_HEADERS
  app_window.h
  display_loss.h
  glfw_input.h
  glfw_keys.h
  imgui_backends.h
  opening.h
  scene_subject.h
  viewer.h
)
set(SOMS_VIEW_SOURCES
  app_window.cpp
  display_loss.cpp
  glfw_keys.cpp
  opening.cpp
  scene_subject.cpp
  subject_events.cpp
  subject_lesson.cpp
  viewer.cpp
)
target_link_libraries(soms_view PRIVATE ${CMAKE_DL_LIBS})
