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

#include <sstream>
#include <stdexcept>

namespace vfc {
namespace {

// Binary, with the numbers of single precision that the format has.
std::string to_stl(const Mesh& mesh)
{
  std::ostringstream out(std::ios::binary);
  CGAL::IO::set_binary_mode(out);
  CGAL::IO::write_STL(out, mesh);
  return out.str();
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

void write_tube(const std::string& file, const Mesh& mesh)
{
  const std::string extension = lower_case_extension(file);
  Output_files::write(file, extension == ".stl" ? to_stl(mesh) : to_text(mesh, extension));
}

} // namespace vfc
