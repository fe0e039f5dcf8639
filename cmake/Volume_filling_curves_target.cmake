# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# Defines CGAL::Volume_filling_curves, unless it is there. The project and each of its subfolders,
# which can be configured alone as in CGAL, include this file.

include_guard(DIRECTORY)
if(TARGET CGAL::Volume_filling_curves)
  return()
endif()

include(${CMAKE_CURRENT_LIST_DIR}/Volume_filling_curves_dependencies.cmake)

add_library(Volume_filling_curves INTERFACE)
add_library(CGAL::Volume_filling_curves ALIAS Volume_filling_curves)

get_filename_component(package_dir ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
target_include_directories(Volume_filling_curves INTERFACE
  $<BUILD_INTERFACE:${package_dir}/include>
  $<INSTALL_INTERFACE:include>)
target_compile_features(Volume_filling_curves INTERFACE cxx_std_17)
# The same input gives the same curve on every machine: no contraction to fused operations.
target_compile_options(Volume_filling_curves INTERFACE
  $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-ffp-contract=off>)
target_link_libraries(Volume_filling_curves INTERFACE CGAL::CGAL CGAL::Eigen3_support)

if(TARGET CGAL::TBB_support)
  target_link_libraries(Volume_filling_curves INTERFACE CGAL::TBB_support)
endif()
