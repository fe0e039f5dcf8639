# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# Dropped into a CGAL checkout: CGALConfig.cmake there takes up every folder that has package_info
# and include. The checkout is a mock around the installed CGAL.

include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
set(checkout ${WORK_DIR}/cgal)
set(installation ${checkout}/Installation)

# Where the installed CGAL keeps its headers: beside some parent folder of its CMake files.
find_path(cgal_include_dir CGAL/config.h NO_CACHE REQUIRED NO_DEFAULT_PATH
  HINTS ${CGAL_DIR}/../../../include ${CGAL_DIR}/../../../../include)

file(MAKE_DIRECTORY ${installation}/package_info/Installation ${installation}/include)
file(GLOB cmake_files ${CGAL_DIR}/*)
file(COPY ${cmake_files} DESTINATION ${installation}/cmake/modules)
file(COPY ${cmake_files} DESTINATION ${installation}/lib/cmake/CGAL)
file(CREATE_LINK ${cgal_include_dir}/CGAL ${installation}/include/CGAL SYMBOLIC)
file(CREATE_LINK ${PACKAGE_DIR} ${checkout}/Volume_filling_curves SYMBOLIC)

set(use_checkout -D CGAL_DIR=${installation}/lib/cmake/CGAL)
build_and_run_consumer(${usage_dir}/cgal_checkout ${use_checkout})

# CGAL's test suite configures each of these folders alone.
foreach(folder IN ITEMS examples test benchmark demo)
  configure(${checkout}/Volume_filling_curves/${folder}/Volume_filling_curves
            ${WORK_DIR}/${folder} ${use_checkout})
endforeach()
