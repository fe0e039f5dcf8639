// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "files/tube_files.h"

#include "files/Output_files.h"
#include "meshes/mesh_to_text.h"
#include "meshes/read_mesh_soup.h"

#include <CGAL/Volume_filling_curves/tube_mesh.h>

#include <CGAL/IO/io.h>
#include <CGAL/boost/graph/IO/STL.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <stdexcept>

namespace vfc {
namespace {

// Whether the corners of each face are different points in single precision, and finite.
bool is_fit_for_single_precision(const Mesh& mesh)
{
  using Corner = std::array<float, 3>;
  const auto corner = [&](Mesh::Vertex_index v) -> Corner {
    const auto& p = mesh.point(v);
    return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
  };
  const auto is_finite = [](float x) { return std::isfinite(x); };
  for(const Mesh::Halfedge_index h : mesh.halfedges()) {
    const Corner source = corner(mesh.source(h));
    if(source == corner(mesh.target(h)) || !std::all_of(source.begin(), source.end(), is_finite))
      return false;
  }
  return true;
}

// Binary, with the numbers of single precision that the format has. Its header is free text.
std::string to_stl(const Mesh& mesh, const std::string& unit)
{
  constexpr std::size_t header_size = 80;
  std::ostringstream out(std::ios::binary);
  CGAL::IO::set_binary_mode(out);
  CGAL::IO::write_STL(out, mesh);
  std::string text = out.str();
  if(unit.empty()) return text;
  std::string header = "UNITS=" + unit;
  header.resize(header_size, ' ');
  return text.replace(0, header_size, header);
}

} // namespace

void add_tube_file(Output_files& outputs, const std::string& option, const std::string& file)
{
  const std::string extension = lower_case_extension(file);
  if(extension != ".stl" && !is_written_mesh_extension(extension))
    throw Usage_error(option + ": " + file +
                      ": tubes are written to .stl, .off, .ply or .obj files");
  outputs.add(option, file);
}

Mesh tube(const Curve& curve, double radius, std::size_t number_of_sides)
{
  namespace curves = CGAL::Volume_filling_curves;
  Mesh mesh;
  try {
    curves::tube_mesh(curve, radius, mesh, curves::parameters::number_of_sides(number_of_sides));
  } catch(const std::invalid_argument& error) {
    throw Usage_error(std::string("--tube: ") + error.what());
  }
  return mesh;
}

void write_tube(const std::string& file, const Mesh& mesh, const std::string& unit)
{
  const std::string extension = lower_case_extension(file);
  const bool is_stl = extension == ".stl";
  if(is_stl && !is_fit_for_single_precision(mesh))
    throw Usage_error("--output: " + file +
                      ": the numbers of STL have single precision, in which " +
                      "the surface is lost; .off, .ply and .obj keep it");
  Output_files::write(file, is_stl ? to_stl(mesh, unit) : to_text(mesh, extension));
}

} // namespace vfc
