# The shared library: named by major and minor version until 1.0, by the major one from then on, and
# showing nothing but names of soms (cmake/library.map).
set(SOMS_SOVERSION ${PROJECT_VERSION_MAJOR})
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(SOMS_SOVERSION 0.${PROJECT_VERSION_MINOR})
endif()
set_target_properties(soms PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${SOMS_SOVERSION})
if(SOMS_SHARED)
  get_target_property(sources soms SOURCES)
  list(FILTER sources INCLUDE REGEX "/detail/.*\\.cpp$")
  set_source_files_properties(${sources} PROPERTIES COMPILE_OPTIONS -fvisibility=hidden)
  # No program puts its own function in the place of one of ours, so they may be inlined and called
  # directly, as in the static library.
  target_compile_options(soms PRIVATE -fno-semantic-interposition)
  set(map ${CMAKE_CURRENT_LIST_DIR}/library.map)
  target_link_options(soms PRIVATE -Wl,-Bsymbolic-functions -Wl,--version-script=${map})
  set_target_properties(soms PROPERTIES LINK_DEPENDS ${map})
endif()
