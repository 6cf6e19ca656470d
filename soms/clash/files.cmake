set(SOMS_HEADERS
  clash.h
  part_bodies.h
  part_keys.h
  print.h
  reference/clash.h)

set(SOMS_SOURCES
  clash.cpp
  part_bodies.cpp
  part_keys.cpp
  print.cpp
  reference/clash.cpp)
