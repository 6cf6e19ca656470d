# What an installed soms is: headers, library, programs, manual, and packages that find_package(soms)
# and pkg-config find. Static and shared library may be installed to one place, by a build of each: a
# kind brings its own targets, and soms-config.cmake chooses.
include(CMakePackageConfigHelpers)
set(kind static)
if(SOMS_SHARED)
  set(kind shared)
endif()
set(SOMS_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/soms)

# All that `cmake --install` copies, without tests and benchmarks. What of it is not built yet is named before
# anything is copied (cmake/built.cmake): `make run` builds the command alone.
add_custom_target(soms_installed)
add_dependencies(soms_installed soms)
set_property(TARGET soms_installed PROPERTY SOMS_FILES "$<TARGET_FILE:soms>")
install(CODE "set(checked \"$<TARGET_GENEX_EVAL:soms_installed,$<TARGET_PROPERTY:soms_installed,SOMS_FILES>>\")
set(folder \"${PROJECT_BINARY_DIR}\")
include(\"${PROJECT_SOURCE_DIR}/cmake/built.cmake\")" ALL_COMPONENTS)

set(libraries soms soms_core)
if(SOMS_BUILD_THESIS AND TARGET soms_thesis)
  list(APPEND libraries soms_thesis)
  if(NOT SOMS_SHARED)
    add_dependencies(soms_installed soms_thesis)
    set_property(TARGET soms_installed APPEND PROPERTY SOMS_FILES "$<TARGET_FILE:soms_thesis>")
  endif()
endif()
install(TARGETS ${libraries} EXPORT soms_targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
  FILE_SET adapters DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(EXPORT soms_targets FILE soms_${kind}_targets.cmake NAMESPACE soms::
  DESTINATION ${SOMS_CMAKE_DIR} COMPONENT development)

set(dependencies Threads)
if(NOT SOMS_SHARED)
  list(APPEND dependencies ${SOMS_LINKED_PACKAGES})
endif()
list(TRANSFORM dependencies REPLACE ".+" "find_dependency(\\0)")
list(JOIN dependencies "\n" dependencies)
configure_file(cmake/soms_kind.cmake.in installed/soms_${kind}.cmake @ONLY)
configure_package_config_file(cmake/soms-config.cmake.in installed/soms-config.cmake
  INSTALL_DESTINATION ${SOMS_CMAKE_DIR})
# For find_package on the build folder, which is no package: it says what to do.
configure_file(cmake/uninstalled.cmake.in soms-config.cmake @ONLY)
write_basic_package_version_file(soms-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/installed/soms-config.cmake
              ${PROJECT_BINARY_DIR}/soms-config-version.cmake
              ${PROJECT_BINARY_DIR}/installed/soms_${kind}.cmake
  DESTINATION ${SOMS_CMAKE_DIR} COMPONENT development)

# The folders of soms.pc are relative to its own place, so that what is installed can be moved.
set(pc_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
set(pc_prefix ${CMAKE_INSTALL_PREFIX})
if(NOT IS_ABSOLUTE ${CMAKE_INSTALL_LIBDIR})
  file(RELATIVE_PATH up /${pc_dir} /)
  string(REGEX REPLACE "/$" "" up ${up})
  set(pc_prefix "\${pcfiledir}/${up}")
endif()
cmake_path(APPEND pc_libdir "\${prefix}" ${CMAKE_INSTALL_LIBDIR})
cmake_path(APPEND pc_includedir "\${prefix}" ${CMAKE_INSTALL_INCLUDEDIR})
# Whoever links the archive links what it needs. Of the shared library nothing is said, not even as
# private: pkg-config would ask for the development packages of all.
set(pc_requires "")
if(NOT SOMS_SHARED)
  list(JOIN SOMS_LINKED_MODULES ", " modules)
  set(pc_requires "Requires: ${modules}\n")
endif()
configure_file(cmake/soms.pc.in soms.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/soms.pc DESTINATION ${pc_dir} COMPONENT development)
if(soms_thesis IN_LIST libraries)
  set(pc_thesis "")
  if(NOT SOMS_SHARED)
    set(pc_thesis "Libs: -L\${libdir} -lsoms-thesis\n")
  endif()
  configure_file(cmake/soms-thesis.pc.in soms-thesis.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/soms-thesis.pc DESTINATION ${pc_dir} COMPONENT development)
endif()

# soms_install_program(<target> <folder> <component>): a program that finds the shared library from
# its own place.
function(soms_install_program target folder component)
  if(NOT TARGET ${target})
    return()
  endif()
  if(SOMS_SHARED AND NOT IS_ABSOLUTE ${CMAKE_INSTALL_LIBDIR})
    file(RELATIVE_PATH libraries /${folder} /${CMAKE_INSTALL_LIBDIR})
    set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN/${libraries}")
  endif()
  install(TARGETS ${target} RUNTIME DESTINATION ${folder} COMPONENT ${component})
  add_dependencies(soms_installed ${target})
  set_property(TARGET soms_installed APPEND PROPERTY SOMS_FILES "$<TARGET_FILE:${target}>")
endfunction()
# The library starts it, so it is installed without the command too.
soms_install_program(soms_import ${CMAKE_INSTALL_LIBEXECDIR}/soms import)
# The same for IFC by web-ifc, where Node.js and that package are; it needs neither to be installed.
if(TARGET soms_import)
  install(FILES apps/import/soms-import-ifc.mjs DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/soms COMPONENT import)
endif()
if(NOT TARGET soms_command)
  return()
endif()
soms_install_program(soms_command ${CMAKE_INSTALL_BINDIR} command)
soms_install_program(soms_reproduce_command ${CMAKE_INSTALL_LIBEXECDIR}/soms command)
soms_install_program(soms_view_command ${CMAKE_INSTALL_LIBEXECDIR}/soms view)

# Pages of the manual and words for the shell, as the command tells them.
if(NOT CMAKE_CROSSCOMPILING)
  set(made ${PROJECT_BINARY_DIR}/manual)
  set(manual ${made}/soms.1 ${made}/soms.bash ${made}/soms.fish)
  set_property(TARGET soms_installed APPEND PROPERTY SOMS_FILES ${manual})
  add_custom_command(OUTPUT ${manual}
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${made}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${made}
    COMMAND soms_command man --quiet --output ${made}
    COMMAND soms_command completion bash > ${made}/soms.bash
    COMMAND soms_command completion fish > ${made}/soms.fish
    DEPENDS soms_command $<$<TARGET_EXISTS:soms_reproduce_command>:soms_reproduce_command>
      $<$<TARGET_EXISTS:soms_view_command>:soms_view_command> VERBATIM)
  add_custom_target(soms_manual ALL DEPENDS ${manual})
  add_dependencies(soms_installed soms_manual)
  install(DIRECTORY ${made}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT command
    FILES_MATCHING PATTERN *.1)
  install(FILES ${made}/soms.bash COMPONENT command RENAME soms
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES ${made}/soms.fish COMPONENT command
    DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
endif()
install(FILES README.md CHANGELOG.md CITATION.cff CONTRIBUTING.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT command)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT command)
