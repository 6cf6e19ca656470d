# Whatever stands here is built.
include(${CMAKE_CURRENT_LIST_DIR}/../../cmake/find_files.cmake)
soms_find_files(SOMS_COMMAND_FILES ${CMAKE_CURRENT_LIST_DIR} *.cpp *.h)
