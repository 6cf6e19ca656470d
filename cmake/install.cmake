# What an installed soms is: headers, library, command, and a package that find_package(soms) finds.
include(CMakePackageConfigHelpers)
install(TARGETS soms EXPORT soms_targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT soms_targets FILE soms_targets.cmake NAMESPACE soms:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/soms)
configure_package_config_file(cmake/soms-config.cmake.in soms-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/soms)
write_basic_package_version_file(soms-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/soms-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/soms-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/soms)
