# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# Writes commit.h with the commit of the sources, marked if they were changed since, so that no two
# builds of a version pass as one. The commit is empty without git or if the sources are not a git
# checkout of their own. The file stays as it is if the commit does.
#
#   cmake -D GIT=git -D SOURCES=folder -D FILE=commit.h -P commit.cmake

function(git result)
  execute_process(COMMAND "${GIT}" -C "${SOURCES}" ${ARGN} RESULT_VARIABLE status
    OUTPUT_VARIABLE output OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT status EQUAL 0)
    set(output "")
  endif()
  set(${result} "${output}" PARENT_SCOPE)
endfunction()

set(commit "")
if(GIT)
  git(top rev-parse --show-toplevel)
  file(REAL_PATH "${SOURCES}" sources)
  if(top STREQUAL sources)
    git(commit describe --always --dirty)
  endif()
endif()
set(text "constexpr char vfc_commit[] = \"${commit}\";\n")
set(former "")
if(EXISTS "${FILE}")
  file(READ "${FILE}" former)
endif()
if(NOT text STREQUAL former)
  file(WRITE "${FILE}" "${text}")
endif()
