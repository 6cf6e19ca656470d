set(SOMS_HEADERS
  scene.h
)
set(SOMS_SOURCES
)
