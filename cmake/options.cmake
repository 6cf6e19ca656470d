# Flags of this project's own builds. They never reach an installed package or a user's target.
add_library(soms_options INTERFACE)
target_compile_options(soms_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor
  -Wold-style-cast -Woverloaded-virtual)
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
# For code that runs briefly, tests above all: under a sanitizer, time to build counts most.
add_library(soms_brief INTERFACE)
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

# soms_precompile(<target> <header>...): parses costly headers once for the target instead of once for
# each of its files. A launcher (ccache) and clang-tidy want each file with all that it includes.
function(soms_precompile target)
  if(NOT CMAKE_CXX_COMPILER_LAUNCHER AND NOT CMAKE_CXX_CLANG_TIDY)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
