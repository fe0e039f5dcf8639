// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PYTHON_ARRAYS_H
#define VFC_PYTHON_ARRAYS_H

#include <CGAL/Volume_filling_curves/Curve_network_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

// NumPy arrays in, curves and meshes out, and back. Points are rows of a float64 array of shape
// (n, 3); edges and faces are rows of an integer array.

namespace vfc_python {

namespace py = pybind11;
namespace VFC = CGAL::Volume_filling_curves;

using Curve = VFC::Curve_network_3<>;
using Point = Curve::Point_3;
using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

// Points; std::invalid_argument, with the name of the array, unless it has three columns.
std::vector<Point> points_of_rows(const Doubles& rows, const char* name);

// Where a component ends that has the points from `first` to `end`: before the last point, if it is
// closed and the last point repeats the first.
std::size_t end_of_component(const Doubles& points,
                             std::size_t first,
                             std::size_t end,
                             bool is_closed);

// A curve from the points of all components, one after another. Component `c` has the points from
// `offsets[c]` to `offsets[c + 1]`, and joins the last to the first if `is_closed[c]`. A repeated
// first point becomes no node, but counts in the origins of nodes.
Curve curve_of_components(const Doubles& points,
                          const std::vector<std::size_t>& offsets,
                          const std::vector<bool>& is_closed);

// A curve from points and edges, with junctions where more than two edges meet.
Curve curve_of_edges(const Doubles& points, const Integers& edges);

// Edges between points; std::invalid_argument if an index is not below their number.
std::vector<std::array<std::size_t, 2>> pairs_of(const Integers& edges,
                                                 std::size_t number_of_points);

// Pins the points with these indices in the input.
void pin(Curve& curve, const std::vector<std::size_t>& points);

// Triangles, which need not bound anything.
struct Triangles
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> faces;
};

Triangles triangles_of(const Doubles& vertices, const Integers& faces);

// A closed triangle mesh; std::invalid_argument if the faces are no oriented manifold.
Mesh mesh_of(const Doubles& vertices, const Integers& faces);

py::tuple arrays_of(const Mesh& mesh); // vertices and faces

Doubles array_of(const std::vector<Point>& points);
Doubles points_of(const Curve& curve);
Integers edges_of(const Curve& curve);
Integers offsets_of(const Curve& curve); // of the components, and the number of nodes at the end
py::list closedness_of(const Curve& curve);

Point point_of(const Doubles& coordinates); // std::invalid_argument unless there are three

} // namespace vfc_python

#endif // VFC_PYTHON_ARRAYS_H
