// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Domain.h"
#include "Run_observer.h"
#include "bindings.h"

#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/draft_to_network.h>
#include <CGAL/Volume_filling_curves/internal/domain/Least_depth.h>

#include <CGAL/tags.h>

#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// Curves that are checked before anything is done with them: by themselves, like curves in files,
// and in a domain.

namespace vfc_python {

namespace {

using Nodes = std::array<std::size_t, 2>; // of an edge, as points of the input
using internal::Curve_draft;
using VFC::Curve_defect_kind;

void add_points(Curve_draft& draft, const Doubles& points)
{
  for(const Point& p : points_of_rows(points, "points")) draft.add_point({p.x(), p.y(), p.z()}, 0);
}

// The edges of a component have its number instead of a line. A repeated first point is in no edge.
Curve_draft draft_of_components(const Doubles& points,
                                const std::vector<std::size_t>& offsets,
                                const std::vector<bool>& is_closed)
{
  Curve_draft draft;
  add_points(draft, points);
  for(std::size_t c = 0; c < is_closed.size(); ++c) {
    const std::size_t first = offsets[c];
    const std::size_t end = end_of_component(points, first, offsets[c + 1], is_closed[c]);
    if(end - first < 2)
      draft.defects.add({Curve_defect_kind::SHORT_LINE, "a curve has fewer than two points", 0,
                         std::vector<std::size_t>(end - first, first + 1), c + 1});
    for(std::size_t i = first; i + 1 < end; ++i) draft.add_edge(i, i + 1, c + 1);
    if(is_closed[c] && end - first > 1) draft.add_edge(end - 1, first, c + 1);
  }
  return draft;
}

Curve_draft draft_of_edges(const Doubles& points, const Integers& edges)
{
  Curve_draft draft;
  add_points(draft, points);
  const auto pairs = pairs_of(edges, draft.points.size());
  for(std::size_t e = 0; e < pairs.size(); ++e) draft.add_edge(pairs[e][0], pairs[e][1], e + 1);
  return draft;
}

// Files are repaired where that changes no curve, but arrays are not.
bool is_refused(Curve_defect_kind kind)
{
  return VFC::is_error(kind) || kind == Curve_defect_kind::COINCIDENT_NODES ||
         kind == Curve_defect_kind::DUPLICATE_EDGE;
}

std::string message_of(const VFC::Curve_defect& defect)
{
  switch(defect.kind) {
  case Curve_defect_kind::COINCIDENT_NODES:
    return "neighbors coincide";
  case Curve_defect_kind::DUPLICATE_EDGE:
    return "an edge is given twice";
  case Curve_defect_kind::ISOLATED_VERTEX:
    return "points are in no edge";
  default:
    return defect.message;
  }
}

py::dict dictionary(const VFC::Curve_defect& defect)
{
  Integers points(static_cast<py::ssize_t>(defect.nodes.size()));
  for(std::size_t i = 0; i < defect.nodes.size(); ++i)
    points.mutable_at(static_cast<py::ssize_t>(i)) = static_cast<std::int64_t>(defect.nodes[i]) - 1;
  py::dict d;
  d["kind"] = VFC::to_string(defect.kind);
  d["is_error"] = is_refused(defect.kind);
  d["message"] = message_of(defect);
  d["points"] = points;
  return d;
}

py::list checked(Curve_draft draft, VFC::Junctions junctions, const py::object& progress)
{
  Curve curve;
  std::vector<VFC::Curve_defect> defects;
  interruptible(
      [&](auto*) { return internal::draft_to_embedded_network(draft, curve, defects, junctions); },
      progress);
  py::list found;
  for(const VFC::Curve_defect& defect : defects) {
    if(defect.kind == Curve_defect_kind::ISOLATED_VERTEX && junctions == VFC::Junctions::FORBIDDEN)
      continue; // repeated first points
    found.append(dictionary(defect));
  }
  return found;
}

Nodes nodes_of_edge(const Curve& curve, std::size_t e)
{
  return {curve.origin(curve.source(e)), curve.origin(curve.target(e))};
}

// The points of the input, and the edges between such, that are not strictly inside.
py::tuple outside(const Curve& curve, const Domain& domain, const py::object& progress)
{
  const auto find = [&](internal::Run_watch* watch) {
    return std::visit(
        [&](const auto& inside) { return internal::find_containment(curve, inside, watch); },
        domain.inside);
  };
  const VFC::Containment found = interruptible(find, progress);
  std::vector<std::size_t> points;
  std::vector<Nodes> edges;
  for(const std::size_t v : found.outside_nodes) points.push_back(curve.origin(v));
  for(const std::size_t e : found.outside_edges) edges.push_back(nodes_of_edge(curve, e));
  return py::make_tuple(points, edges);
}

template <typename Inside>
VFC::Wall_distance_3<Point> nearest_to_wall(const Curve& curve,
                                            const Inside& inside,
                                            internal::Run_watch* watch)
{
  internal::check_inside(curve, inside);
  using Least_depth = internal::Least_depth<CGAL::Parallel_if_available_tag, Curve, Inside>;
  const auto nearest = Least_depth(curve, inside, watch)();
  return {nearest.distance, nearest.edge, internal::to_point(nearest.point, curve.traits())};
}

py::dict wall_distance(const Curve& curve, const Domain& domain, const py::object& progress)
{
  if(curve.number_of_edges() == 0) throw std::invalid_argument("there is no curve");
  const auto find = [&](internal::Run_watch* watch) {
    return std::visit([&](const auto& inside) { return nearest_to_wall(curve, inside, watch); },
                      domain.inside);
  };
  const auto nearest = interruptible(find, progress);
  py::dict d;
  d["distance"] = nearest.distance;
  d["point"] = array_of({nearest.point}).attr("__getitem__")(0);
  d["edge"] = nodes_of_edge(curve, nearest.edge);
  return d;
}

} // namespace

void bind_checks(py::module_& module)
{
  module.def("check_curves", [](const Doubles& points, const std::vector<std::size_t>& offsets,
                                const std::vector<bool>& is_closed, const py::object& progress) {
    return checked(draft_of_components(points, offsets, is_closed), VFC::Junctions::FORBIDDEN,
                   progress);
  });
  module.def("check_curves",
             [](const Doubles& points, const Integers& edges, const py::object& progress) {
               return checked(draft_of_edges(points, edges), VFC::Junctions::ALLOWED, progress);
             });
  module.def("outside", &outside);
  module.def("wall_distance", &wall_distance);
}

} // namespace vfc_python
