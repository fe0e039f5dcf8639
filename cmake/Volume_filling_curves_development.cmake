# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# What the project's own programs are built with: the target Volume_filling_curves_development
# (warnings, sanitizers) and precompiled headers.

include_guard(GLOBAL)

set(VFC_SANITIZE "" CACHE STRING "Sanitizers to build with, such as address,undefined or thread")
option(VFC_WARNINGS_ARE_ERRORS "Stop at the first warning" ON)
option(VFC_PRECOMPILE "Precompile the headers of CGAL and Eigen" ON)
# Sources of one module use the same templates, which are compiled only a few times then.
option(VFC_UNITY_BUILD
  "Compile the sources of a module together: faster from scratch, slower after a change"
  OFF)

add_library(Volume_filling_curves_development INTERFACE)
target_link_libraries(Volume_filling_curves_development INTERFACE CGAL::Volume_filling_curves)
target_compile_options(Volume_filling_curves_development INTERFACE
  -Wall -Wextra -Wshadow -Wconversion -Wpedantic
  $<$<BOOL:${VFC_WARNINGS_ARE_ERRORS}>:-Werror>)
if(VFC_SANITIZE)
  set(sanitizer_flags -fsanitize=${VFC_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    list(APPEND sanitizer_flags
      -fsanitize-ignorelist=${CMAKE_CURRENT_LIST_DIR}/sanitizer_ignorelist.txt)
  endif()
  if(VFC_SANITIZE MATCHES address AND VFC_SANITIZE MATCHES undefined)
    # AddressSanitizer finds what object-size does, for which clang++ takes a tenth of its time.
    list(APPEND sanitizer_flags -fno-sanitize=object-size)
  endif()
  target_compile_options(Volume_filling_curves_development INTERFACE ${sanitizer_flags})
  target_link_options(Volume_filling_curves_development INTERFACE ${sanitizer_flags})
endif()

# Precompiles what nearly every source of `target` reads. Of further targets with the same options
# the first one's file can be used: pass it as `owner`.
function(vfc_precompile target)
  if(VFC_PRECOMPILE AND ARGC GREATER 1)
    target_precompile_headers(${target} REUSE_FROM ${ARGV1})
  elseif(VFC_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE
      <CGAL/Exact_predicates_inexact_constructions_kernel.h> <Eigen/Sparse> <vector>)
  endif()
endfunction()
