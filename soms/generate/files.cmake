set(SOMS_HEADERS
  city.h
  routes.h
  shapes.h
  urban.h
)
set(SOMS_SOURCES
)
