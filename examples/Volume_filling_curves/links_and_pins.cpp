// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Untangles links, reports whether they are linked, and untangles arcs with pinned and with sliding
// ends.

#include <CGAL/Volume_filling_curves/untangle.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace VFC = CGAL::Volume_filling_curves;

using Curve = VFC::Curve_network_3<>;
using Point_3 = Curve::Point_3;
using Vector_3 = Curve::Traits::Vector_3;
using Polyline = std::vector<Point_3>;

// An ellipse in a plane that is orthogonal to y or to z
Polyline ellipse(double center, bool is_upright)
{
  Polyline points;
  const int n = 60;
  for(int i = 0; i < n; ++i) {
    const double x = center + 2 * std::cos(2 * CGAL_PI * i / n), h = std::sin(2 * CGAL_PI * i / n);
    points.push_back(is_upright ? Point_3(x, 0, h) : Point_3(x, h, 0));
  }
  points.push_back(points.front());
  return points;
}

VFC::Link_status status_of_link(double distance)
{
  std::vector<Polyline> link = {ellipse(0, false), ellipse(distance, true)};
  const VFC::Untangling_result result = VFC::untangle(link, VFC::parameters::tolerance(0.02));
  std::cout << "ellipses at distance " << distance << ": " << result.statistics.iterations
            << " iterations, "
            << (result.link == VFC::Link_status::LINKED ? "linked" : "not linked") << '\n';
  return result.link;
}

// A winding arc, whose pinned nodes stay in place.
bool does_arc_stay_pinned()
{
  Polyline arc;
  for(int i = 0; i <= 80; ++i) arc.emplace_back(0.1 * i, std::sin(0.4 * i), std::cos(0.4 * i));
  //! [pins]
  Curve curve(arc);
  curve.pin_ends();
  curve.set_pinned(40);

  const VFC::Untangling_result result = VFC::untangle(curve);
  //! [pins]
  std::size_t pinned = 0, new_nodes = 0;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) {
    const std::size_t origin = curve.origin(v); // the node of the input that became v
    if(origin == Curve::null_node()) ++new_nodes;
    if(!curve.is_pinned(v)) continue;
    if(curve.point(v) != arc[origin]) return false;
    ++pinned;
  }
  std::cout << "arc: " << result.statistics.iterations << " iterations, " << pinned
            << " pinned nodes and " << new_nodes << " new ones of " << curve.number_of_nodes()
            << '\n';
  return pinned == 3;
}

// An arc between the planes z = 0 and z = 3, on which its ends slide.
bool does_arc_become_vertical()
{
  Polyline arc;
  for(int i = 0; i <= 60; ++i) arc.emplace_back(0.05 * i, std::sin(0.3 * i), 0.05 * i);
  //! [slide]
  Curve curve(arc);
  for(const std::size_t v : {std::size_t(0), curve.number_of_nodes() - 1})
    curve.set_constraint(v, VFC::Node_constraint::on_plane(curve.point(v), Vector_3(0, 0, 1)));

  VFC::untangle(curve);
  //! [slide]
  const Point_3 first = curve.point(0), last = curve.point(curve.number_of_nodes() - 1);
  std::cout << "arc between planes: from (" << first << ") to (" << last << ")\n";
  return std::abs(last.x() - first.x()) < 0.1 && first.z() == 0 && last.z() == 0.05 * 60;
}

int main()
{
  const bool is_ok = status_of_link(2) == VFC::Link_status::LINKED &&
                     status_of_link(5) == VFC::Link_status::TRIVIAL && does_arc_stay_pinned() &&
                     does_arc_become_vertical();
  return is_ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
