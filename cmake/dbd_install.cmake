# cmake --install: libraries and headers for find_package(dbd CONFIG) and pkg-config; cpack -G DEB
# makes a Debian package of the same.
include(CMakePackageConfigHelpers)

install(TARGETS dbd_core dbd_terrain dbd_planner EXPORT dbdTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(module core terrain planner)
  install(DIRECTORY ${module}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    PATTERN internal EXCLUDE)
endforeach()

set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/dbd)
install(EXPORT dbdTargets NAMESPACE dbd:: DESTINATION ${package_directory})
configure_package_config_file(cmake/dbdConfig.cmake.in ${PROJECT_BINARY_DIR}/dbdConfig.cmake
  INSTALL_DESTINATION ${package_directory})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/dbdConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/dbdConfig.cmake ${PROJECT_BINARY_DIR}/dbdConfigVersion.cmake
  cmake/dbd_library_dependencies.cmake DESTINATION ${package_directory})

install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)

# JSON Schema of every file that the program reads or writes.
install(DIRECTORY docs/schemas/ DESTINATION ${CMAKE_INSTALL_DATADIR}/dbd/schemas)

file(RELATIVE_PATH DBD_PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/dbd.pc.in ${PROJECT_BINARY_DIR}/dbd.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/dbd.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

set(CPACK_PACKAGE_CONTACT "dbd developers <dbd@localhost>")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS
  ${PROJECT_BINARY_DIR}/core ${PROJECT_BINARY_DIR}/terrain ${PROJECT_BINARY_DIR}/planner)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libeigen3-dev, nlohmann-json3-dev, libspdlog-dev, libtbb-dev, libgdal-dev, libompl-dev, liboctomap-dev, libassimp-dev")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
include(CPack)
