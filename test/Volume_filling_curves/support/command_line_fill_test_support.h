// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_COMMAND_LINE_FILL_TEST_SUPPORT_H
#define VFC_TEST_COMMAND_LINE_FILL_TEST_SUPPORT_H

#include "support/program_test_support.h"

// A cube for tests of the program to fill.
namespace command_line_fill_test {

class Command_line_fill : public program_test::Program_test
{
protected:
  // a cube with sides of 4
  void make_cube() const
  {
    write("cube.off", "OFF\n8 12 0\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n0 0 4\n4 0 4\n4 4 4\n0 4 4\n"
                      "3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n"
                      "3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n");
  }

  // two ports
  void make_arc() const { write("arc.obj", "v 0.5 2 2\nv 3.5 2 2\nl 1 2\n"); }
};

} // namespace command_line_fill_test

#endif // VFC_TEST_COMMAND_LINE_FILL_TEST_SUPPORT_H
