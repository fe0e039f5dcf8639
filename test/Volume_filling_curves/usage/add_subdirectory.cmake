# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# add_subdirectory, which must not build the package's own programs and tests.

include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
build_and_run_consumer(${usage_dir}/add_subdirectory
  -D PACKAGE_DIR=${PACKAGE_DIR} -D CGAL_DIR=${CGAL_DIR})
