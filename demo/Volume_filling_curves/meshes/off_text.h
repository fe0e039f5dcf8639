// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_OFF_TEXT_H
#define VFC_OFF_TEXT_H

#include "files/mesh_files.h"
#include "meshes/mesh_text.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace vfc {

// The content of an OFF file in text form, and its defects. CGAL's reader, which reads each
// line through a stream of its own, takes five times as long, refuses files without a reason, and
// allocates whatever a file announces; it is left what keywords with a fourth coordinate or another
// number of them announce, and what it may understand in spite of a problem. Not with textures,
// colors or normals: it reads beyond lines that lack them.
struct Off_text
{
  explicit Off_text(std::string_view text);

  // returns whether points and polygons are all that the file holds
  bool is_complete() const { return is_plain && problems.empty(); }

  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  std::vector<Text_problem> problems;
  bool is_plain = false;   // there is a header, and vertices begin with three coordinates
  bool has_extras = false; // textures, colors or normals, or claims to
};

// returns the text of an OFF file with a line for each vertex and face, as CGAL's reader wants it
std::string off_with_lines(const std::string& text);

} // namespace vfc

#endif // VFC_OFF_TEXT_H
