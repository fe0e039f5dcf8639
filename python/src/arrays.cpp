// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "arrays.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <array>
#include <stdexcept>
#include <string>

namespace vfc_python {

namespace {

void check_shape(const py::array& array, py::ssize_t columns, const char* name)
{
  if(array.ndim() != 2 || array.shape(1) != columns)
    throw std::invalid_argument(std::string(name) + " must have the shape (n, " +
                                std::to_string(columns) + ")");
}

// Rows of indices below `end`; anything else is a wrong index of `name`.
template <std::size_t columns>
std::vector<std::array<std::size_t, columns>> indices_of_rows(const Integers& rows,
                                                              std::size_t end,
                                                              const char* name)
{
  check_shape(rows, columns, name);
  const auto x = rows.unchecked<2>();
  std::vector<std::array<std::size_t, columns>> result(static_cast<std::size_t>(x.shape(0)));
  for(std::size_t i = 0; i < result.size(); ++i)
    for(std::size_t k = 0; k < columns; ++k) {
      const std::int64_t index = x(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k));
      if(index < 0 || static_cast<std::size_t>(index) >= end)
        throw std::invalid_argument(std::string(name) + ": row " + std::to_string(i) +
                                    " has the index " + std::to_string(index) + ", but there are " +
                                    std::to_string(end) + " points");
      result[i][k] = static_cast<std::size_t>(index);
    }
  return result;
}

template <typename Row, typename Set>
Row rows(std::size_t count, py::ssize_t columns, const Set& set)
{
  Row result({static_cast<py::ssize_t>(count), columns});
  auto x = result.template mutable_unchecked<2>();
  for(std::size_t i = 0; i < count; ++i) {
    const auto values = set(i);
    for(py::ssize_t k = 0; k < columns; ++k)
      x(static_cast<py::ssize_t>(i), k) = values[static_cast<std::size_t>(k)];
  }
  return result;
}

std::array<double, 3> coordinates(const Point& p)
{
  return {p.x(), p.y(), p.z()};
}

} // namespace

std::vector<Point> points_of_rows(const Doubles& rows, const char* name)
{
  check_shape(rows, 3, name);
  const auto x = rows.unchecked<2>();
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(x.shape(0)));
  for(py::ssize_t i = 0; i < x.shape(0); ++i) points.emplace_back(x(i, 0), x(i, 1), x(i, 2));
  return points;
}

std::size_t end_of_component(const Doubles& points,
                             std::size_t first,
                             std::size_t end,
                             bool is_closed)
{
  if(!is_closed || end - first < 2) return end;
  const auto x = points.unchecked<2>();
  const auto one = static_cast<py::ssize_t>(first), other = static_cast<py::ssize_t>(end - 1);
  for(py::ssize_t k = 0; k < 3; ++k)
    if(x(one, k) != x(other, k)) return end;
  return end - 1;
}

Curve curve_of_components(const Doubles& points,
                          const std::vector<std::size_t>& offsets,
                          const std::vector<bool>& is_closed)
{
  std::vector<std::array<std::size_t, 2>> edges;
  edges.reserve(static_cast<std::size_t>(points.shape(0)));
  for(std::size_t c = 0; c < is_closed.size(); ++c) {
    const std::size_t first = offsets[c];
    const std::size_t end = end_of_component(points, first, offsets[c + 1], is_closed[c]);
    if(end - first < (is_closed[c] ? 3U : 2U))
      throw std::invalid_argument(
          "curve " + std::to_string(c) + " has " + std::to_string(end - first) + " points, but " +
          (is_closed[c] ? "a closed curve has at least 3" : "an open curve has at least 2"));
    for(std::size_t i = first; i + 1 < end; ++i) edges.push_back({i, i + 1});
    if(is_closed[c]) edges.push_back({end - 1, first});
  }
  return Curve(points_of_rows(points, "a curve"), edges);
}

Curve curve_of_edges(const Doubles& points, const Integers& edges)
{
  const std::vector<Point> p = points_of_rows(points, "points");
  return Curve(p, pairs_of(edges, p.size()));
}

std::vector<std::array<std::size_t, 2>> pairs_of(const Integers& edges,
                                                 std::size_t number_of_points)
{
  return indices_of_rows<2>(edges, number_of_points, "edges");
}

void pin(Curve& curve, const std::vector<std::size_t>& points)
{
  std::vector<std::size_t> node_of;
  for(const std::size_t v : curve.nodes()) {
    const std::size_t point = curve.origin(v);
    if(point >= node_of.size()) node_of.resize(point + 1, Curve::null_node());
    node_of[point] = v;
  }
  for(const std::size_t point : points) {
    if(point >= node_of.size() || node_of[point] == Curve::null_node())
      throw std::invalid_argument("pin: there is no point " + std::to_string(point) +
                                  ", or it repeats the first point of its curve");
    curve.set_pinned(node_of[point]);
  }
}

Triangles triangles_of(const Doubles& vertices, const Integers& faces)
{
  Triangles triangles;
  triangles.points = points_of_rows(vertices, "vertices");
  triangles.faces = indices_of_rows<3>(faces, triangles.points.size(), "faces");
  return triangles;
}

Mesh mesh_of(const Doubles& vertices, const Integers& faces)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  const Triangles triangles = triangles_of(vertices, faces);
  if(!PMP::is_polygon_soup_a_polygon_mesh(triangles.faces))
    throw std::invalid_argument("faces: they are no oriented manifold; use repair()");
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(triangles.points, triangles.faces, mesh);
  return mesh;
}

py::tuple arrays_of(const Mesh& mesh)
{
  const auto vertex = [&](std::size_t i) {
    return coordinates(mesh.point(Mesh::Vertex_index(static_cast<Mesh::size_type>(i))));
  };
  const auto face = [&](std::size_t i) {
    std::array<std::int64_t, 3> corners;
    auto corner = corners.begin();
    const auto h = mesh.halfedge(Mesh::Face_index(static_cast<Mesh::size_type>(i)));
    for(const auto v : mesh.vertices_around_face(h)) *corner++ = static_cast<std::int64_t>(v.idx());
    return corners;
  };
  return py::make_tuple(rows<Doubles>(mesh.number_of_vertices(), 3, vertex),
                        rows<Integers>(mesh.number_of_faces(), 3, face));
}

Doubles array_of(const std::vector<Point>& points)
{
  return rows<Doubles>(points.size(), 3, [&](std::size_t i) { return coordinates(points[i]); });
}

Doubles points_of(const Curve& curve)
{
  return rows<Doubles>(curve.number_of_nodes(), 3,
                       [&](std::size_t v) { return coordinates(curve.point(v)); });
}

Integers edges_of(const Curve& curve)
{
  return rows<Integers>(curve.number_of_edges(), 2, [&](std::size_t e) {
    return std::array<std::int64_t, 2>{static_cast<std::int64_t>(curve.source(e)),
                                       static_cast<std::int64_t>(curve.target(e))};
  });
}

Integers offsets_of(const Curve& curve)
{
  Integers result(static_cast<py::ssize_t>(curve.number_of_components() + 1));
  auto x = result.mutable_unchecked<1>();
  for(std::size_t c = 0; c <= curve.number_of_components(); ++c)
    x(static_cast<py::ssize_t>(c)) = static_cast<std::int64_t>(curve.first_node(c));
  return result;
}

py::list closedness_of(const Curve& curve)
{
  py::list result;
  for(const std::size_t c : curve.components()) result.append(curve.is_closed(c));
  return result;
}

Point point_of(const Doubles& coordinates)
{
  if(coordinates.ndim() != 1 || coordinates.shape(0) != 3)
    throw std::invalid_argument("a point must have three coordinates");
  const auto x = coordinates.unchecked<1>();
  return {x(0), x(1), x(2)};
}

} // namespace vfc_python
