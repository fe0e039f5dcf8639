// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_COMMAND_LINE_MESHES_TEST_SUPPORT_H
#define VFC_TEST_COMMAND_LINE_MESHES_TEST_SUPPORT_H

#include "support/program_test_support.h"

#include <string>
#include <vector>

// Surfaces for tests of the program.
namespace command_line_meshes_test {

using program_test::Json;

inline const std::string cube_vertices = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\n"
                                         "v 0 0 4\nv 4 0 4\nv 4 4 4\nv 0 4 4\n";

inline const std::string cube_faces = "f 1 3 2\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\n"
                                      "f 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\n";

class Command_line_meshes : public program_test::Program_test
{
protected:
  // a cube with sides of 4 and a square loop of sides of 2 in its middle
  void make_files() const
  {
    write("cube.obj", cube_vertices + cube_faces);
    write("square.obj", "v 1 1 2\nv 3 1 2\nv 3 3 2\nv 1 3 2\nl 1 2 3 4 1\n");
  }

  std::vector<std::string> kinds(const std::string& report) const
  {
    std::vector<std::string> result;
    const Json all = json(report);
    for(const Json& defect : all["defects"]) result.push_back(defect["kind"]);
    return result;
  }
};

} // namespace command_line_meshes_test

#endif // VFC_TEST_COMMAND_LINE_MESHES_TEST_SUPPORT_H
