# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# The three ways in which another project uses the package, each really done: installed and found,
# as a subdirectory, and dropped into a CGAL checkout.

foreach(way IN ITEMS find_package add_subdirectory cgal_checkout)
  add_test(NAME usage_${way}
    COMMAND ${CMAKE_COMMAND}
      -D PACKAGE_DIR=${package_dir}
      -D WORK_DIR=${CMAKE_CURRENT_BINARY_DIR}/usage/${way}
      -D CGAL_DIR=${CGAL_DIR}
      -D COMPILER=${CMAKE_CXX_COMPILER}
      -P ${CMAKE_CURRENT_SOURCE_DIR}/usage/${way}.cmake)
  set_tests_properties(usage_${way} PROPERTIES LABELS usage TIMEOUT 300)
endforeach()
if(NOT CMAKE_SOURCE_DIR STREQUAL package_dir) # only the whole project can be installed
  set_tests_properties(usage_find_package PROPERTIES DISABLED TRUE)
endif()

add_test(NAME usage_wrong_types
  COMMAND ${CMAKE_COMMAND}
    -D COMPILER=${CMAKE_CXX_COMPILER}
    "-DINCLUDES=$<TARGET_PROPERTY:Volume_filling_curves_test_settings,INTERFACE_INCLUDE_DIRECTORIES>"
    -P ${CMAKE_CURRENT_SOURCE_DIR}/usage/wrong_types.cmake)
set_tests_properties(usage_wrong_types PROPERTIES LABELS usage TIMEOUT 300)
