set(SOMS_HEADERS
  eigen.h
  glm.h
)
