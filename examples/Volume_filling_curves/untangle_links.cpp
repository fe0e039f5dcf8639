// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Untangles links of two components, and reports whether they come apart.

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>

namespace VFC = CGAL::Volume_filling_curves;

using Curve = VFC::Curve_network_3<>;

VFC::Link_status status_of(const char* name, Curve link)
{
  //! [link]
  const VFC::Untangling_result result = VFC::untangle(link);
  std::cout << name << ": linking number " << VFC::linking_matrix(link)[0][1] << ", "
            << result.link;
  //! [link]
  for(const std::size_t c : link.components())
    std::cout << ", component " << c << " of length " << VFC::component_lengths(link)[c];
  std::cout << '\n';
  return result.link;
}

int main()
{
  using VFC::Link_status;
  // Two linked rings
  const bool are_linked =
      status_of("Hopf link", VFC::make_torus_knot(2, 2, 100)) == Link_status::LINKED;
  // Two strands that wind around each other and back
  const bool are_apart = status_of("unlink", VFC::make_closed_braid({1, 1, 1, -1, -1, -1}, 150)) ==
                         Link_status::TRIVIAL;
  return are_linked && are_apart ? EXIT_SUCCESS : EXIT_FAILURE;
}
