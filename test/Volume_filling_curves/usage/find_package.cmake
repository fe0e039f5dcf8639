# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# cmake --install, then find_package(Volume_filling_curves).

include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix)
build_and_run_consumer(${usage_dir}/find_package
  -D CMAKE_PREFIX_PATH=${WORK_DIR}/prefix -D CGAL_DIR=${CGAL_DIR})
