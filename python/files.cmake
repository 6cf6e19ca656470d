# Whatever stands in src is built.
include(${CMAKE_CURRENT_LIST_DIR}/../cmake/find_files.cmake)
soms_find_files(SOMS_PYTHON_FILES ${CMAKE_CURRENT_LIST_DIR}/src *.cpp *.h)
list(TRANSFORM SOMS_PYTHON_FILES PREPEND src/)
set(SOMS_PYTHON_TWIN bench/twin.cpp)
