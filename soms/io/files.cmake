set(SOMS_HEADERS
  poses.h
  read_mesh.h
  write_mesh.h
)
set(SOMS_SOURCES
)
