// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// What the others are compared with: CGAL's AABB tree of triangles and its kd-tree.

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>

#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
using Search = CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Kernel>>;

int main()
{
  const std::vector<Kernel::Point_3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Triangles triangles = {{points[0], points[1], points[2]},
                               {points[0], points[1], points[3]}};
  Tree tree(triangles.begin(), triangles.end());
  std::cout << tree.closest_point(points[3]) << ' ' << tree.do_intersect(triangles[0]) << '\n';
  Search::Tree points_tree(points.begin(), points.end());
  const Search search(points_tree, points[0], 2);
  for(const auto& neighbor : search) std::cout << neighbor.second << '\n';
}
