set(SOMS_HEADERS
  clash.h
  part_bodies.h
  part_keys.h
  penetration.h
  print.h
  reference/clash.h)

set(SOMS_SOURCES
  clash.cpp
  detail/open_parts.cpp
  detail/pair_of_parts.cpp
  part_bodies.cpp
  part_keys.cpp
  penetration.cpp
  print.cpp
  reference/clash.cpp)
