# soms_find_files(<result> <folder> <pattern>...): the names of files in a folder and below it, sorted. Each build looks
# whether there are others now: for folders that get a file with every new query (docs/decisions/0096).
function(soms_find_files result folder)
  list(TRANSFORM ARGN PREPEND ${folder}/)
  file(GLOB_RECURSE found RELATIVE ${folder} CONFIGURE_DEPENDS ${ARGN})
  set(${result} ${found} PARENT_SCOPE)
endfunction()
