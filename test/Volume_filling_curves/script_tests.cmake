# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# Tests that are scripts run the program, but for those in layout/, which read the sources. They
# find the program and the data through the environment. Those of sources, scripts and pages, and of
# bits, which have the label "once", run in one variant. They start before the shards of the other
# tests: with sanitizers, one of them takes three times as long as a shard.

file(GLOB scripts CONFIGURE_DEPENDS
  ${CMAKE_CURRENT_SOURCE_DIR}/*/test_*.sh ${CMAKE_CURRENT_SOURCE_DIR}/*/test_*.py)
if(NOT TARGET vfc)
  list(FILTER scripts INCLUDE REGEX "/layout/")
endif()
foreach(script IN LISTS scripts)
  get_filename_component(name ${script} NAME)
  if(name MATCHES "\\.py$")
    set(interpreter /usr/bin/python3) # the system's, which has Regina
  else()
    set(interpreter bash)
  endif()
  add_test(NAME ${name} COMMAND ${interpreter} ${script})
  set_tests_properties(${name} PROPERTIES
    ENVIRONMENT "${places}" SKIP_RETURN_CODE 77 TIMEOUT 600 LABELS script COST 500)
  if(name MATCHES "^test_long_")
    set_tests_properties(${name} PROPERTIES LABELS "long;script" TIMEOUT 1500 COST 1000)
  elseif(script MATCHES "/layout/|/test_(benchmark_script|commit|film_in_browser|vectorization)[.]py$")
    set_tests_properties(${name} PROPERTIES LABELS "once;script")
  elseif(name MATCHES "^test_example_")
    set_tests_properties(${name} PROPERTIES LABELS "example;script") # where examples are built
  endif()
endforeach()
if(TARGET tour AND TARGET read_write_curves)
  set_property(TEST test_example_quotes.py APPEND PROPERTY
    ENVIRONMENT VFC_EXAMPLES=$<TARGET_FILE_DIR:tour>)
endif()
