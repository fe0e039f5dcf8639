# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# The target headers_alone: each header, public and internal, included twice and by nothing before.
# A header that another one includes first of all is compiled with that one.

option(VFC_HEADERS_ALONE "Compile each header alone as part of the build" ON)

file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${package_dir}/include
  ${package_dir}/include/CGAL/*.h)
set(included_first)
foreach(header IN LISTS headers)
  file(STRINGS ${package_dir}/include/${header} includes REGEX "^#include" LIMIT_COUNT 2)
  if("${includes}" MATCHES "^#include <CGAL/license/[^>]*>;#include <(CGAL/Volume_filling_curves/[^>]*)>$")
    list(APPEND included_first ${CMAKE_MATCH_1})
  endif()
endforeach()
list(REMOVE_ITEM headers ${included_first})

set(units)
foreach(header IN LISTS headers)
  string(MAKE_C_IDENTIFIER ${header} name)
  set(unit ${CMAKE_CURRENT_BINARY_DIR}/headers_alone/${name}.cpp)
  file(CONFIGURE OUTPUT ${unit} CONTENT "#include <${header}>\n#include <${header}>\n")
  list(APPEND units ${unit})
endforeach()

add_library(headers_alone OBJECT ${units})
target_link_libraries(headers_alone PRIVATE Volume_filling_curves_development)
target_compile_options(headers_alone PRIVATE -O0 -g0) # there is nothing to run
if(VFC_SANITIZE)
  target_compile_options(headers_alone PRIVATE -fno-sanitize=all)
endif()
if(NOT VFC_HEADERS_ALONE)
  set_target_properties(headers_alone PROPERTIES EXCLUDE_FROM_ALL TRUE)
endif()
