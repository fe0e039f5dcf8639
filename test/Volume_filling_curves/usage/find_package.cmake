# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# The headers are installed, for which nothing must be built, then find_package(Volume_filling_curves).

include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
set(package_build ${WORK_DIR}/package)
configure(${PACKAGE_DIR} ${package_build} -D CGAL_DIR=${CGAL_DIR}
  -D CMAKE_INSTALL_PREFIX=${WORK_DIR}/other_prefix)

# Both ways to install; by default the second one builds everything first.
run(${CMAKE_COMMAND} --install ${package_build} --prefix ${WORK_DIR}/prefix)
run(${CMAKE_COMMAND} --build ${package_build} --target install)
file(GLOB_RECURSE built ${package_build}/*.o ${package_build}/*.gch ${package_build}/bin/*)
if(built)
  message(FATAL_ERROR "Installing the headers has built ${built}")
endif()

build_and_run_consumer(${usage_dir}/find_package
  -D CMAKE_PREFIX_PATH=${WORK_DIR}/prefix -D CGAL_DIR=${CGAL_DIR})
