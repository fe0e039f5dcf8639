// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Reads valid and invalid curves, and writes them without changing a bit.

#include <CGAL/Volume_filling_curves/IO/curve_network.h>

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace VFC = CGAL::Volume_filling_curves;

using Curve = VFC::Curve_network_3<>;

//! [read]
// Prints every defect of the curve in a file, and returns whether the curve is usable.
bool read(const std::string& filename, Curve& curve)
{
  std::vector<VFC::Curve_defect> defects;
  const bool is_good = CGAL::IO::read_embedded_curve_network(filename, curve, defects);
  for(const VFC::Curve_defect& defect : defects)
    std::cout << VFC::to_string(defect, filename) << '\n';
  return is_good;
}
//! [read]

bool are_equal(const Curve& a, const Curve& b)
{
  if(a.number_of_nodes() != b.number_of_nodes()) return false;
  for(std::size_t v = 0; v < a.number_of_nodes(); ++v)
    if(a.point(v) != b.point(v) || a.is_pinned(v) != b.is_pinned(v)) return false;
  return true;
}

int main()
{
  // A bow tie, whose edges cross: an error. The duplicate edge is only a warning.
  std::ofstream("bow_tie.obj") << "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\n"
                                  "l 1 2 3 4 1\nl 1 2\n";
  Curve curve;
  if(read("bow_tie.obj", curve)) return EXIT_FAILURE;

  // A closed curve, since the polyline ends where it starts, and an arc with a pinned end
  std::ofstream("two_curves.obj") << "v 0 0 0\nv 1 0 0\nv 0.1 1 0\nl 1 2 3 1\n"
                                     "v 0 0 1\nv 1 0 1\nv 2 0 1\nl 4 5 6\nfixed 4\n";
  if(!read("two_curves.obj", curve)) return EXIT_FAILURE;
  for(std::size_t c = 0; c < curve.number_of_components(); ++c)
    std::cout << "component " << c << " is " << (curve.is_closed(c) ? "closed" : "open") << '\n';

  Curve copy;
  if(!CGAL::IO::write_curve_network("copy.obj", curve) || !read("copy.obj", copy))
    return EXIT_FAILURE;
  return are_equal(curve, copy) ? EXIT_SUCCESS : EXIT_FAILURE;
}
