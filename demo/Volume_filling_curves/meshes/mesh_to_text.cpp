// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/mesh_to_text.h"

#include "meshes/examine_mesh.h"
#include "options/numbers.h"

#include <cstddef>

namespace vfc {
namespace {

// Differences between the formats; their lines of points and faces are alike.
struct Format
{
  const char *extension, *before_point, *before_face;
  std::size_t first_index;
};

constexpr Format formats[] = {
    {".off", "", "3 ", 0}, {".obj", "v ", "f ", 1}, {".ply", "", "3 ", 0}};

const Format* format_of(const std::string& extension)
{
  for(const Format& format : formats)
    if(extension == format.extension) return &format;
  return nullptr;
}

std::string header(const Mesh_soup& soup, const std::string& extension)
{
  const std::string points = std::to_string(soup.points.size());
  const std::string faces = std::to_string(soup.faces.size());
  if(extension == ".off") return "OFF\n" + points + ' ' + faces + " 0\n";
  if(extension == ".obj") return "";
  return "ply\nformat ascii 1.0\nelement vertex " + points +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " + faces +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

} // namespace

bool is_written_mesh_extension(const std::string& extension)
{
  return format_of(extension) != nullptr;
}

std::string to_text(const Mesh& mesh, const std::string& extension)
{
  return to_text(soup_of(mesh), extension);
}

std::string to_text(const Mesh_soup& soup, const std::string& extension)
{
  const Format& format = *format_of(extension);
  std::string text = header(soup, extension);
  for(const auto& p : soup.points) {
    text += format.before_point;
    for(int axis = 0; axis < 3; ++axis) {
      text += to_exact_text(p[axis]);
      text += axis < 2 ? ' ' : '\n';
    }
  }
  for(const Mesh_soup::Face& face : soup.faces) {
    text += format.before_face;
    for(const std::size_t v : face) text += std::to_string(v + format.first_index) + ' ';
    text.back() = '\n';
  }
  return text;
}

} // namespace vfc
