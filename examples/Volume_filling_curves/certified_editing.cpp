// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Edits a curve by hand. The guard carries out the changes that it can certify, and refuses others.

#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdlib>
#include <iostream>

namespace VFC = CGAL::Volume_filling_curves;

using Curve = VFC::Curve_network_3<>;
using Guard = VFC::Isotopy_guard_3<>;
using Point_3 = Curve::Point_3;

// Prints the outcome of a change, and returns whether it was expected.
bool report(const char* change, bool is_done, bool is_expected)
{
  std::cout << (is_done ? "done:    " : "refused: ") << change << '\n';
  return is_done == is_expected;
}

int main()
{
  // A triangle, the nodes 0 to 2, stands beside a rod, the nodes 3 and 4.
  Curve curve(
      {Point_3(1, -1, 0), Point_3(1, 1, 0), Point_3(3, 0, 0), Point_3(0, 0, -2), Point_3(0, 0, 2)},
      {{0, 1}, {1, 2}, {2, 0}, {3, 4}});
  //! [edit]
  Guard guard(curve);

  bool is_ok = report("a corner through the rod", guard.move_node(2, Point_3(-3, 0, 0)), false);

  // A strand can slip off an arc: the guarantee is that no strand passes through another one.
  is_ok &= report("the corner over the rod's end", guard.move_node(2, Point_3(-3, 0, 10)), true);
  is_ok &= report("the corner down behind the rod", guard.move_node(2, Point_3(-3, 0, 0)), true);
  is_ok &= report("the corner back through the rod", guard.move_node(2, Point_3(3, 0, 0)), false);

  // Insertions and removals of nodes are certified as well.
  is_ok &= report("a node in the edge in front", guard.insert_node(0, Point_3(2, 0, 0)), true);
  const std::size_t inserted = curve.target(0);
  is_ok &= report("to straighten the edge again", guard.remove_node(inserted), true);
  //! [edit]
  is_ok &= report("to remove the end of the rod", guard.remove_node(3), false);

  // Removed nodes leave gaps in the numbering until they are collected.
  const auto former_index = guard.collect_garbage();
  is_ok &= former_index.size() == 5 && curve.number_of_nodes() == 5;

  // With a clearance, changes that bring strands too close are refused as well.
  guard.set_clearance(0.25);
  is_ok &= report("an edge to within 0.2 of the rod, with a clearance of 0.25",
                  guard.insert_node(0, Point_3(0.2, 0, 0)), false);
  is_ok &=
      report("an edge to within 0.3 of the rod", guard.insert_node(0, Point_3(0.3, 0, 0)), true);

  // All nodes move upwards together, as far as certified, but at least half of the way.
  guard.collect_garbage();
  const auto n = static_cast<Eigen::Index>(curve.number_of_nodes());
  Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> targets(n, 3);
  for(Eigen::Index v = 0; v < n; ++v) {
    const Point_3& p = curve.point(static_cast<std::size_t>(v));
    targets.row(v) << p.x(), p.y(), p.z() + 0.1;
  }
  const double fraction = guard.move_nodes(targets, 0.5);
  is_ok &= report("all nodes upwards", fraction == 1, true);

  std::cout << guard.number_of_certified_changes() << " changes certified, "
            << guard.number_of_refused_changes() << " refused\n";
  return is_ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
