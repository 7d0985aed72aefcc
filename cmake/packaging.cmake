# What `cmake --install` puts beside program and library: headers, the package for find_package(), the
# examples; and the Debian package that `cpack` makes of it all.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/vibroimpact)

install(DIRECTORY src/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/vibroimpact
  FILES_MATCHING PATTERN "*.h")
install(EXPORT vibroimpactTargets NAMESPACE vibroimpact:: DESTINATION ${package_folder})
configure_package_config_file(cmake/vibroimpactConfig.cmake.in
  ${PROJECT_BINARY_DIR}/generated/vibroimpactConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/generated/vibroimpactConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/generated/vibroimpactConfig.cmake
  ${PROJECT_BINARY_DIR}/generated/vibroimpactConfigVersion.cmake
  DESTINATION ${package_folder})
install(DIRECTORY params meshes DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)
install(FILES README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_CONTACT "The vibroimpact project")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_STRIP_FILES TRUE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS TRUE)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS TRUE)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS
  "openmpi-bin, python3, python3-h5py, python3-matplotlib, python3-xarray")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "paraview")
# The library is stripped when it is packaged, before the dependencies are looked for.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR})
include(CPack)
