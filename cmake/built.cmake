# Runs first in `cmake --install`: ends it, before anything is copied, where a file of `checked` is not built yet in
# the build `folder`, and says how to build it. One component alone asks for its own files only, which CMake checks.
if(CMAKE_INSTALL_COMPONENT)
  return()
endif()
set(missing "")
foreach(file IN LISTS checked)
  if(NOT EXISTS ${file})
    cmake_path(GET file FILENAME name)
    string(APPEND missing " ${name}")
  endif()
endforeach()
if(missing)
  message(FATAL_ERROR "Nothing was installed, as not all of soms is built yet. Missing:${missing}\n"
    "Build the rest, then install again:\n  cmake --build ${folder} --target soms_installed\n")
endif()
