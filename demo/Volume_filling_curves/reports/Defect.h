// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_DEFECT_H
#define VFC_DEFECT_H

#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>

#include <cstddef>
#include <string>
#include <vector>

namespace vfc {

// The location of a defect in a mesh file. Numbers count from 1; unknown ones are 0 or empty.
struct Mesh_location
{
  std::size_t line = 0;
  std::vector<std::size_t> vertices = {}, faces = {};
  std::size_t shell = 0;
};

// A defect of an input, curve or mesh, in the words of the report. Numbers count from 1; unknown
// ones are 0 or empty.
struct Defect
{
  std::string kind;
  bool is_error;
  std::string file;
  std::size_t line = 0;
  std::vector<std::size_t> nodes = {}; // of a mesh its vertices
  std::vector<std::size_t> faces = {};
  std::size_t component = 0; // of a mesh the shell
  std::string message;
  std::string text; // the complete line

  Defect(const CGAL::Volume_filling_curves::Curve_defect& defect, const std::string& file);

  Defect(const std::string& kind,
         bool is_error,
         const std::string& file,
         const Mesh_location& location,
         const std::string& message);

  // Error of a curve without a line in its file, such as a node outside a mesh.
  Defect(const std::string& kind,
         const std::string& file,
         const std::vector<std::size_t>& nodes,
         std::size_t component,
         const std::string& message);
};

using Defects = std::vector<Defect>;

// The library's defects of one file.
template <typename LibraryDefect>
Defects make_defects(const std::vector<LibraryDefect>& found, const std::string& file)
{
  Defects defects;
  for(const LibraryDefect& defect : found) defects.emplace_back(defect, file);
  return defects;
}

} // namespace vfc

#endif // VFC_DEFECT_H
