# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# Compiles what users get wrong: the errors of the compiler hold each sentence that the source expects.

set(source ${CMAKE_CURRENT_LIST_DIR}/wrong_types.cpp)
list(TRANSFORM INCLUDES PREPEND -I)
if(COMPILER MATCHES clang)
  set(all_errors -ferror-limit=0)
endif()
execute_process(COMMAND ${COMPILER} -std=c++17 -fsyntax-only ${all_errors} ${INCLUDES} ${source}
  ERROR_VARIABLE errors RESULT_VARIABLE status)
if(status EQUAL 0)
  message(FATAL_ERROR "It compiles")
endif()
file(STRINGS ${source} sentences REGEX "// refused: ")
foreach(sentence IN LISTS sentences)
  string(REGEX REPLACE ".*// refused: " "" sentence "${sentence}")
  string(FIND "${errors}" "${sentence}" position)
  if(position EQUAL -1)
    message(SEND_ERROR "No error says: ${sentence}")
  endif()
endforeach()
