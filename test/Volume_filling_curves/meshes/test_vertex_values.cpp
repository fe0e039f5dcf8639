// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/vertex_values.h"
#include "support/mesh_file_test_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace test_vertex_values {

using namespace mesh_file_test;

class Vertex_values : public Mesh_file
{
protected:
  // reads what `text` says into `values` and lists its defects
  bool read_values(const std::string& name, const std::string& text, std::size_t number = 2)
  {
    const std::string path = write(name, text);
    vfc::Mesh_findings findings(name);
    values = vfc::read_vertex_values(path, "thickness", number, findings);
    defects = findings.list();
    return !findings.has_error();
  }

  std::vector<double> values;
};

TEST_F(Vertex_values, are_read_from_text_and_ply)
{
  EXPECT_TRUE(read_values("a.csv", "thickness\n# of three\n1\n2.5,\n\n3e-1\n", 3));
  EXPECT_EQ(values, (std::vector<double>{1, 2.5, .3}));
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                             "property double thickness\nproperty float z\nend_header\n";
  EXPECT_TRUE(read_values("a.ply", header + "0 .25 1\n1 4 0\n"));
  EXPECT_EQ(values, (std::vector<double>{.25, 4}));
  std::string binary = "ply\nformat binary_little_endian 1.0\nelement vertex 2\n"
                       "property float thickness\nend_header\n";
  for(const float value : {.5f, 3.f}) {
    std::array<char, sizeof(float)> bytes;
    std::copy_n(reinterpret_cast<const char*>(&value), sizeof(float), bytes.begin());
    binary.append(bytes.data(), bytes.size());
  }
  EXPECT_TRUE(read_values("b.ply", binary));
  EXPECT_EQ(values, (std::vector<double>{.5, 3}));
  EXPECT_FALSE(read_values("c.ply", header + "0 .25 1\n"));
}

TEST_F(Vertex_values, that_are_bad_are_named_with_their_line)
{
  struct Case
  {
    const char *name, *text;
    const char* kind;
    std::size_t line;
  };
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                             "property double thickness\nend_header\n";
  const std::string minus = header + "0 1\n0 -1\n", word = header + "0 1\n0 one\n",
                    cut = header + "0 1\n";
  for(const Case& c : {
          Case{"a.csv", "1\nx\n", "unparsable number", 2},
          Case{"b.csv", "1\n2 3\n", "unparsable number", 2},
          Case{"c.csv", "r\n1\n0\n", "bad value", 3},
          Case{"d.csv", "1\nnan\n", "unparsable number", 2},
          Case{"e.csv", "1\n2\n3\n", "wrong value count", 0},
          Case{"f.csv", "", "wrong value count", 0},
          Case{"g.ply", minus.c_str(), "bad value", 0},
          Case{"h.ply", word.c_str(), "unparsable number", 8},
          Case{"i.ply", cut.c_str(), "truncated file", 8},
          Case{"j.ply",
               "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nend_header\n0\n0\n",
               "missing property", 0},
          Case{"k.ply", "nonsense", "unknown format", 1},
      }) {
    EXPECT_FALSE(read_values(c.name, c.text)) << c.name;
    ASSERT_FALSE(defects.empty());
    EXPECT_EQ(defects[0].kind, c.kind) << defects[0].text;
    EXPECT_EQ(defects[0].line, c.line) << c.name;
  }
  vfc::Mesh_findings findings("no_such_file.csv");
  vfc::read_vertex_values("no_such_file.csv", "thickness", 2, findings);
  EXPECT_TRUE(findings.has_error());
}

} // namespace test_vertex_values
