# Whatever stands here is built and, but for what is private, installed.
include(${CMAKE_CURRENT_LIST_DIR}/../../cmake/find_files.cmake)
soms_find_files(SOMS_HEADERS ${CMAKE_CURRENT_LIST_DIR} *.h)
list(FILTER SOMS_HEADERS EXCLUDE REGEX "(^|/)detail/")
soms_find_files(SOMS_SOURCES ${CMAKE_CURRENT_LIST_DIR} *.cpp)
