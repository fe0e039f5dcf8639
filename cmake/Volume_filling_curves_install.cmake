# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# Installs the headers and the files with which find_package(Volume_filling_curves) works.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(config_dir ${CMAKE_INSTALL_DATADIR}/cmake/Volume_filling_curves)
# The installed package must find again what the exported target names, and only that.
set(use_TBB OFF)
if(TARGET CGAL::TBB_support)
  set(use_TBB ON)
endif()

configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/Volume_filling_curvesConfig.cmake.in
  ${PROJECT_BINARY_DIR}/cmake/Volume_filling_curvesConfig.cmake
  INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/cmake/Volume_filling_curvesConfigVersion.cmake
  COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/CGAL DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS Volume_filling_curves EXPORT Volume_filling_curvesTargets)
install(EXPORT Volume_filling_curvesTargets NAMESPACE CGAL:: DESTINATION ${config_dir})
install(FILES
  ${PROJECT_BINARY_DIR}/cmake/Volume_filling_curvesConfig.cmake
  ${PROJECT_BINARY_DIR}/cmake/Volume_filling_curvesConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/Volume_filling_curves_dependencies.cmake
  DESTINATION ${config_dir})
