# What run.json says of the build. Both headers are included by run/build.cpp alone, so that a new commit compiles
# one small file: build_settings.h is written by CMake, revision.h by each build.
string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
set(standard "")
if(CMAKE_CXX_STANDARD_COMPUTED_DEFAULT LESS 20)
  set(standard ${CMAKE_CXX20_EXTENSION_COMPILE_OPTION})
endif()
set(position "")
if(SOMS_SHARED)
  set(position ${CMAKE_CXX_COMPILE_OPTIONS_PIC})
endif()
# Of the library, without its warnings.
set(flags ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} ${position} ${standard}
  $<FILTER:$<TARGET_PROPERTY:soms,COMPILE_OPTIONS>,EXCLUDE,^-W>)
set(settings ${CMAKE_CURRENT_BINARY_DIR}/made/build_settings.h)
file(GENERATE OUTPUT ${settings} CONTENT
"#define SOMS_VERSION R\"soms(${PROJECT_VERSION})soms\"
#define SOMS_BUILD_TYPE R\"soms(${CMAKE_BUILD_TYPE})soms\"
#define SOMS_BUILD_FLAGS R\"soms($<JOIN:${flags}, >)soms\"
")
set(revision ${CMAKE_CURRENT_BINARY_DIR}/made/revision.h)
add_custom_target(soms_revision
  COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D HEADER=${revision}
    -P ${PROJECT_SOURCE_DIR}/cmake/revision.cmake
  BYPRODUCTS ${revision} COMMENT "Looking up the commit" VERBATIM)
add_dependencies(soms_reproduce soms_revision)
set_property(SOURCE run/build.cpp APPEND PROPERTY INCLUDE_DIRECTORIES ${CMAKE_CURRENT_BINARY_DIR}/made)
