# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# Finds what CGAL::Volume_filling_curves links to. Required: CGAL (which brings Boost) and Eigen.
# Used when found, unless switched off: TBB. Used in the build and by the installed package.

option(Volume_filling_curves_WITH_TBB "Run in parallel with TBB when it is found" ON)

find_package(CGAL 5.5 REQUIRED QUIET)
find_package(Eigen3 3.4 REQUIRED QUIET)
include(CGAL_Eigen3_support)

if(Volume_filling_curves_WITH_TBB)
  find_package(TBB QUIET)
  include(CGAL_TBB_support)
endif()

# A parent project (add_subdirectory) must see the imported targets too.
get_directory_property(imported_targets IMPORTED_TARGETS)
foreach(target IN LISTS imported_targets)
  set_target_properties(${target} PROPERTIES IMPORTED_GLOBAL TRUE)
endforeach()
