set(SOMS_HEADERS
  tree_file.h
)
set(SOMS_SOURCES
  detail/mapped_file.cpp
  tree_file.cpp
)
