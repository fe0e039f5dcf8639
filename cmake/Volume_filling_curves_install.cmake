# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# Installs the headers and the files with which find_package(Volume_filling_curves) works.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(libraries TBB CHOLMOD ZLIB)
set(targets CGAL::TBB_support CHOLMOD::CHOLMOD ZLIB::ZLIB)
set(config_dir ${CMAKE_INSTALL_DATADIR}/cmake/Volume_filling_curves)
# The installed package must find again what the exported target names, and only that.
foreach(library target IN ZIP_LISTS libraries targets)
  if(TARGET ${target})
    set(use_${library} ON)
  else()
    set(use_${library} OFF)
  endif()
endforeach()

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
  ${CMAKE_CURRENT_LIST_DIR}/FindCHOLMOD.cmake
  DESTINATION ${config_dir})
