# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# A reader of STEP files, if OpenCASCADE is installed, on Debian libocct-data-exchange-dev. Its own
# package file also wants the libraries for displays.

find_path(VFC_OCCT_INCLUDE_DIR STEPControl_Reader.hxx PATH_SUFFIXES opencascade)
find_library(VFC_OCCT_STEP_LIBRARY TKSTEP)
if(NOT VFC_OCCT_INCLUDE_DIR OR NOT VFC_OCCT_STEP_LIBRARY OR NOT TARGET vfc)
  list(APPEND places VFC_READ_STEP=)
  return()
endif()
add_executable(read_step EXCLUDE_FROM_ALL arc_files/read_step.cpp)
target_include_directories(read_step SYSTEM PRIVATE ${VFC_OCCT_INCLUDE_DIR})
target_link_libraries(read_step PRIVATE TKSTEP TKXSBase TKTopAlgo TKBRep TKG3d TKGeomBase TKMath TKernel)
add_dependencies(tests read_step)
list(APPEND places VFC_READ_STEP=$<TARGET_FILE:read_step>)
