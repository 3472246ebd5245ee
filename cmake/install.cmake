# What find_package(rift) needs: headers, libraries, and how to compile with
# them. Programs that use rift take part in its options, among them -march: the
# width of its vectors is part of the interface.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/rift)
install(TARGETS rift_options rift_kernels rift_core EXPORT rift_targets)
install(TARGETS rift rift-elasticity)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/rift
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT rift_targets NAMESPACE rift:: DESTINATION ${package})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/riftConfig.cmake.in
  ${PROJECT_BINARY_DIR}/riftConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/riftConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/riftConfig.cmake
  ${PROJECT_BINARY_DIR}/riftConfigVersion.cmake DESTINATION ${package})
