# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# The target headers_alone: each header, public and internal, included twice and by nothing before.

option(VFC_HEADERS_ALONE "Compile each header alone as part of the build" ON)

file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${package_dir}/include
  ${package_dir}/include/CGAL/*.h)
foreach(header IN LISTS headers)
  string(MAKE_C_IDENTIFIER ${header} name)
  set(unit ${CMAKE_CURRENT_BINARY_DIR}/headers_alone/${name}.cpp)
  file(CONFIGURE OUTPUT ${unit} CONTENT "#include <${header}>\n#include <${header}>\n")
  list(APPEND units ${unit})
endforeach()

add_library(headers_alone OBJECT ${units})
target_link_libraries(headers_alone PRIVATE Volume_filling_curves_development)
target_compile_options(headers_alone PRIVATE -O0 -g0) # there is nothing to run
if(NOT VFC_HEADERS_ALONE)
  set_target_properties(headers_alone PROPERTIES EXCLUDE_FROM_ALL TRUE)
endif()
