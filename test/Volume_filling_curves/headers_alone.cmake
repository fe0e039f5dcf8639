# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# The target headers_alone checks that each header, public and internal, compiles by itself, included
# twice. Nothing is written, and each time all is checked again.
#
# A header that includes some of `shared_headers`, directly or through others, is compiled with those
# precompiled. This hides no missing #include: a header's own lines follow all that it includes, and
# each header that it includes is checked as well.
#
# A unit is a chain of headers with the same `shared_headers`, each of which includes the one before:
# 178 units for 314 headers. This hides nothing either, since a header's own lines follow all that it
# includes, and what stands before it is a part of that.

set(shared_headers # read by many, and slow to read
  CGAL/Volume_filling_curves/internal/geometry/Vector.h
  CGAL/Volume_filling_curves/Curve_flow_traits_3.h
  CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h
  CGAL/Volume_filling_curves/internal/search/Box_tree.h)

file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${package_dir}/include
  ${package_dir}/include/CGAL/*.h)
foreach(header IN LISTS headers)
  file(STRINGS ${package_dir}/include/${header} includes REGEX "^#include <")
  list(TRANSFORM includes REPLACE "#include <(.*)>" "\\1")
  foreach(included IN LISTS includes)
    list(APPEND readers_of_${included} ${header})
  endforeach()
endforeach()

# Lists, in `shared_by_HEADER`, those of `shared_headers` that it reads.
foreach(shared IN LISTS shared_headers)
  set(readers ${readers_of_${shared}})
  while(readers)
    list(POP_FRONT readers reader)
    if(NOT <${shared}> IN_LIST shared_by_${reader})
      list(APPEND shared_by_${reader} <${shared}>)
      list(APPEND readers ${readers_of_${reader}})
    endif()
  endwhile()
endforeach()

# Puts each header before one of its readers.
set(ends_of_chains)
foreach(header IN LISTS headers)
  set(next)
  foreach(reader IN LISTS readers_of_${header})
    if(NOT next AND NOT DEFINED before_${reader} AND
       "${shared_by_${reader}}" STREQUAL "${shared_by_${header}}")
      set(next ${reader})
    endif()
  endforeach()
  if(next)
    set(before_${next} ${header})
  else()
    list(APPEND ends_of_chains ${header})
  endif()
endforeach()

# Chains that share the same headers are compiled together.
set(groups)
foreach(end IN LISTS ends_of_chains)
  set(includes)
  set(header ${end})
  while(header)
    string(PREPEND includes "#include <${header}>\n#include <${header}>\n")
    set(header ${before_${header}})
  endwhile()
  string(MAKE_C_IDENTIFIER ${end} name)
  set(unit ${CMAKE_CURRENT_BINARY_DIR}/headers_alone/${name}.cpp)
  file(CONFIGURE OUTPUT ${unit} CONTENT "${includes}")
  string(MAKE_C_IDENTIFIER "alone_${shared_by_${end}}" group)
  list(APPEND groups ${group})
  list(APPEND units_of_${group} ${unit})
  set(precompiled_for_${group} ${shared_by_${end}})
endforeach()
list(REMOVE_DUPLICATES groups)

add_custom_target(headers_alone)
set(number_of_groups 0)
foreach(group IN LISTS groups)
  math(EXPR number_of_groups "${number_of_groups} + 1")
  set(library headers_alone_${number_of_groups})
  add_library(${library} OBJECT EXCLUDE_FROM_ALL ${units_of_${group}})
  set_source_files_properties(${units_of_${group}} PROPERTIES COMPILE_OPTIONS -fsyntax-only)
  target_link_libraries(${library} PRIVATE Volume_filling_curves_development)
  if(VFC_SANITIZE)
    target_compile_options(${library} PRIVATE -fno-sanitize=all)
  endif()
  list(LENGTH units_of_${group} number_of_units)
  if(number_of_units LESS 4)
    set(precompiled_for_${group}) # it would take as long as three units
  endif()
  if(VFC_PRECOMPILE AND precompiled_for_${group})
    target_precompile_headers(${library} PRIVATE ${precompiled_for_${group}})
  endif()
  add_dependencies(headers_alone ${library})
endforeach()
