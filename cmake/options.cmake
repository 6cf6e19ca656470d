# Flags of this project's own builds. They never reach an installed package, a user's target, or a project around this one.
add_library(soms_options INTERFACE)
if(PROJECT_IS_TOP_LEVEL)
  target_compile_options(soms_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor
    -Wold-style-cast -Woverloaded-virtual)
endif()
if(SOMS_SANITIZE)
  target_compile_options(soms_options INTERFACE
    -fsanitize=${SOMS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(soms_options INTERFACE -fsanitize=${SOMS_SANITIZE})
  # What g++ says of uninitialized and overlapping memory in code that a sanitizer has rewritten is
  # often untrue (its manual, -fsanitize); the release build keeps both warnings.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(soms_options INTERFACE -Wno-maybe-uninitialized -Wno-restrict)
  endif()
endif()
# For code that runs briefly, tests and the programs' own above all: time to build counts most. A lot of eight files of
# apps/soms took 25.2 s with -O3 and 16.5 s with -O1; what takes a user's time is the library.
add_library(soms_brief INTERFACE)
target_compile_options(soms_brief INTERFACE $<$<CONFIG:Release>:-O1>)
if(SOMS_SANITIZE)
  target_compile_options(soms_brief INTERFACE -O0)
endif()
if(SOMS_FUZZ)
  target_compile_options(soms_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
set(SOMS_ASSERTIONS OFF)
if(SOMS_SANITIZE OR CMAKE_BUILD_TYPE STREQUAL "Debug")
  set(SOMS_ASSERTIONS ON)
endif()
if(SOMS_ASSERTIONS)
  target_compile_definitions(soms_options INTERFACE SOMS_ASSERTIONS=1)
endif()

# soms_unite(<target> [<n>]): compiles the target's files n at a time, eight by default, as their
# headers cost more than what stands in them (docs/decisions/0028). A launcher (ccache) wants each file
# alone, the analyzer of clang-tidy too, and so may who edits one file again and again.
option(SOMS_UNITE "Compile several files at once" ON)
function(soms_may_unite target result)
  get_target_property(tidy ${target} CXX_CLANG_TIDY)
  set(${result} OFF PARENT_SCOPE)
  if(SOMS_UNITE AND NOT CMAKE_CXX_COMPILER_LAUNCHER AND NOT tidy MATCHES "^clang-tidy$")
    set(${result} ON PARENT_SCOPE)
  endif()
endfunction()
function(soms_unite target)
  soms_may_unite(${target} may)
  if(may)
    set(size 8)
    if(ARGC GREATER 1)
      set(size ${ARGV1})
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${size})
  endif()
endfunction()
# soms_unite_files(<target> <name> <files>...): the same for some files of a target, in lots of at
# most 13 that bear the name; all others are compiled alone (docs/decisions/0040).
function(soms_unite_files target name)
  soms_may_unite(${target} may)
  if(NOT may)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  set(index 0)
  foreach(file IN LISTS ARGN)
    math(EXPR lot "${index} / 13")
    set_source_files_properties(${file} PROPERTIES UNITY_GROUP ${name}_${lot})
    math(EXPR index "${index} + 1")
  endforeach()
endfunction()
