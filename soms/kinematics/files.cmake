set(SOMS_HEADERS
  kinematics.h
  link_pairs.h
  primitive_meshes.h
  print.h
  robot.h)

set(SOMS_SOURCES
  kinematics.cpp
  link_pairs.cpp
  primitive_meshes.cpp
  print.cpp
  robot.cpp)
