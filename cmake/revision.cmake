# Writes a header with the commit of the source tree, as part of every build; the file is touched only where the
# commit changed. "unknown" outside a checkout, as in an unpacked archive.
#   cmake -D SOURCE=<source folder> -D HEADER=<file to write> -P revision.cmake
cmake_minimum_required(VERSION 3.25)
set(commit "")
find_program(GIT git)
if(GIT)
  # An archive may be unpacked inside the checkout of something else.
  execute_process(COMMAND ${GIT} rev-parse --show-toplevel WORKING_DIRECTORY ${SOURCE}
    OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  file(REAL_PATH "${SOURCE}" source)
  if(top)
    file(REAL_PATH "${top}" top)
  endif()
  if(top STREQUAL source)
    # Tags are left out, as a tag alone would not name the commit.
    execute_process(
      COMMAND ${GIT} --no-optional-locks describe --always --dirty --abbrev=40 --exclude=*
      WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE
      ERROR_QUIET)
  endif()
endif()
if(NOT commit)
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#define SOMS_COMMIT \"@commit@\"\n" @ONLY)
