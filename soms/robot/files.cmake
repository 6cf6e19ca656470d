set(SOMS_HEADERS
  print.h
  robot_model.h
  robot_query.h
  reference/robot_query.h)

set(SOMS_SOURCES
  detail/state_query.cpp
  print.cpp
  robot_model.cpp
  robot_query.cpp
  reference/robot_query.cpp)
