# soms_page_program(<page> <number>): the program of docs/<page>.md is built, run, and prints what the
# page shows.
function(soms_page_program page number)
  set(name page_${page}_${number})
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  set(script ${CMAKE_CURRENT_SOURCE_DIR}/page_program.py)
  set(path ${PROJECT_SOURCE_DIR}/docs/${page}.md)
  add_custom_command(OUTPUT ${source}
    COMMAND ${Python3_EXECUTABLE} ${script} source ${path} ${number} > ${source}
    DEPENDS ${path} ${script} VERBATIM)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE soms::thesis soms_options)
  add_test(NAME docs.${name}
    COMMAND ${Python3_EXECUTABLE} ${script} run ${path} ${number} $<TARGET_FILE:${name}>)
  set_tests_properties(docs.${name} PROPERTIES LABELS docs)
endfunction()

soms_page_program(scene 1)
soms_page_program(scene 2)
soms_page_program(scene 3)
soms_page_program(scene 4)
soms_page_program(scene 5)
soms_page_program(trees 1)
soms_page_program(trees 2)
