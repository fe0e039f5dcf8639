// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Thickness_field.h"

#include "numbers.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/version_macros.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <utility>
#include <vector>

namespace vfc {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Values = std::vector<double>;

// Finds the closest point of the surface, and interpolates between the corners of its face.
class Field
{
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

public:
  Field(const Mesh& mesh, Values values)
      : m_mesh(mesh),
        m_values(std::move(values)),
        m_tree(faces(m_mesh).first, faces(m_mesh).second, m_mesh)
  {
    m_tree.build(); // before several threads ask
    m_tree.accelerate_distance_queries();
  }

  double operator()(const Kernel::Point_3& p) const
  {
    namespace pmp = CGAL::Polygon_mesh_processing;
    const auto [face, weights] = pmp::locate_with_AABB_tree(p, m_tree, m_mesh);
    double sum = 0;
    std::size_t k = 0;
    for(const auto v : CGAL::vertices_around_face(m_mesh.halfedge(face), m_mesh))
      sum += std::clamp(weights[k++], 0., 1.) * m_values[v];
    return sum;
  }

private:
  const Mesh m_mesh;
  const Values m_values; // per vertex of the mesh
  Tree m_tree;
};

// CGAL 5 returns a map and whether there is one, CGAL 6 an optional.
template <typename Property>
bool has_value(const Property& property)
{
  if constexpr(CGAL_VERSION_MAJOR < 6)
    return property.second;
  else
    return property.has_value();
}

template <typename Property>
const auto& value(const Property& property)
{
  if constexpr(CGAL_VERSION_MAJOR < 6)
    return property.first;
  else
    return *property;
}

[[noreturn]] void refuse(const std::string& file, const std::string& why)
{
  throw Usage_error("--thickness-field: " + file + ": " + why);
}

Values read_ply(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  Mesh mesh;
  std::string comments;
  if(!in || !CGAL::IO::read_PLY(in, mesh, comments, false))
    refuse(file, "cannot be read as the PLY file of a mesh");
  Values values;
  const auto copy = [&](const auto& property) {
    for(const auto v : vertices(mesh)) values.push_back(static_cast<double>(property[v]));
  };
  const auto doubles = mesh.property_map<Mesh::Vertex_index, double>("v:thickness");
  const auto floats = mesh.property_map<Mesh::Vertex_index, float>("v:thickness");
  if(has_value(doubles))
    copy(value(doubles));
  else if(has_value(floats))
    copy(value(floats));
  else
    refuse(file, "has no vertex property thickness of type float or double");
  return values;
}

Values read_csv(const std::string& file)
{
  std::ifstream in(file);
  if(!in) refuse(file, "cannot be read");
  Values values;
  std::size_t number = 0;
  for(std::string line; std::getline(in, line);) {
    ++number;
    while(!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    double r = 0;
    if(parse(line, r))
      values.push_back(r);
    else if(number > 1 && !line.empty()) // the first line may be a title
      refuse(file, "line " + std::to_string(number) + ": '" + line + "' is not a number");
  }
  return values;
}

} // namespace

Thickness read_thickness_field(const std::string& file, const Mesh_and_defects& mesh)
{
  const std::string extension = std::filesystem::path(file).extension().string();
  const Values values = extension == ".ply" ? read_ply(file) : read_csv(file);
  Values at_vertex;
  for(const std::size_t origin : mesh.origins) {
    if(origin >= values.size())
      refuse(file, "has " + std::to_string(values.size()) + " values, too few for the mesh");
    if(!(values[origin] > 0))
      refuse(file, "the value of vertex " + std::to_string(origin + 1) + " is not positive");
    at_vertex.push_back(values[origin]);
  }
  const auto field = std::make_shared<const Field>(mesh.mesh, std::move(at_vertex));
  return [field](const Curve::Point_3& p) { return (*field)(p); };
}

} // namespace vfc
