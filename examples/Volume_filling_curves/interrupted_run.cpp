// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Ends a run at a limit, and resumes it.

#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <cstdlib>
#include <functional>
#include <iostream>

namespace vfc = CGAL::Volume_filling_curves;
namespace parameters = CGAL::Volume_filling_curves::parameters;

int main()
{
  const vfc::Curve_network_3<> knot = vfc::make_torus_knot(2, 5, 100);
  vfc::Curve_network_3<> whole = knot, part = knot, rest = knot;
  vfc::untangle(whole);

  //! [resume]
  vfc::Run_state state;
  const auto save = [&](const vfc::Run_checkpoint& checkpoint) {
    if(checkpoint.is_last) state = checkpoint.state();
  };
  vfc::untangle(part, parameters::number_of_iterations(5).checkpoint(save));
  vfc::untangle(rest, parameters::resume_from(std::cref(state)));
  //! [resume]

  bool are_same = !state.is_empty() && rest.number_of_nodes() == whole.number_of_nodes();
  for(std::size_t v = 0; are_same && v < rest.number_of_nodes(); ++v)
    are_same = rest.point(v) == whole.point(v);
  std::cout << (are_same ? "the same" : "another") << " curve as without a limit\n";
  return are_same ? EXIT_SUCCESS : EXIT_FAILURE;
}
