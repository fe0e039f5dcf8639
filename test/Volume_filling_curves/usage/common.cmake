# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# Shared by the tests of usage. Each begins with an empty WORK_DIR.

cmake_minimum_required(VERSION 3.21)
set(usage_dir ${CMAKE_CURRENT_LIST_DIR})
file(REMOVE_RECURSE ${WORK_DIR})

# Runs a command; ends the test where it fails.
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Configures, builds and runs the project in `source`, a program named consumer.
function(build_and_run_consumer source)
  configure(${source} ${WORK_DIR}/build ${ARGN})
  run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)
  run(${WORK_DIR}/build/consumer)
endfunction()

function(configure source build)
  run(${CMAKE_COMMAND} -S ${source} -B ${build} -G Ninja
      -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=Debug
      -D CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON ${ARGN})
endfunction()
