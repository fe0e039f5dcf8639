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
  vfc::Curve_network_3<> whole = knot;
  vfc::untangle(whole);

  //! [resume]
  vfc::Run_state state; // empty: start from the beginning
  vfc::Curve_network_3<> curve;
  vfc::Untangling_result result;
  std::size_t limit = 5;
  do {
    curve = knot;
    const vfc::Run_state former = state;
    const auto save = [&](const vfc::Run_checkpoint& checkpoint) {
      if(checkpoint.is_last) state = checkpoint.state();
    };
    result = vfc::untangle(
        curve,
        parameters::number_of_iterations(limit).checkpoint(save).resume_from(std::cref(former)));
    std::cout << result.status << " after " << result.statistics.iterations << " iterations\n";
    limit += 5;
  } while(result.status == vfc::Untangling_status::LIMIT);
  //! [resume]

  bool are_same = curve.number_of_nodes() == whole.number_of_nodes();
  for(std::size_t v = 0; are_same && v < curve.number_of_nodes(); ++v)
    are_same = curve.point(v) == whole.point(v);
  std::cout << (are_same ? "the same" : "another") << " curve as without a limit\n";
  return are_same ? EXIT_SUCCESS : EXIT_FAILURE;
}
