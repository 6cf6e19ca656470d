set(SOMS_HEADERS
  print.h
  robot_model.h
  robot_path.h
  robot_query.h
  reference/robot_query.h)

set(SOMS_SOURCES
  detail/chain_law.cpp
  detail/path_query.cpp
  detail/robot_chains.cpp
  detail/state_motion.cpp
  detail/state_query.cpp
  print.cpp
  robot_model.cpp
  robot_path.cpp
  robot_query.cpp
  reference/robot_query.cpp)
