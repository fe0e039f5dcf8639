// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Run_observer.h"
#include "arrays.h"
#include "bindings.h"

#include <CGAL/Volume_filling_curves/generators.h>

#include <pybind11/stl.h>

#include <cstddef>
#include <vector>

namespace vfc_python {

void bind_generators(py::module_& module)
{
  using std::size_t;
  module.def("torus_knot", [](int p, int q, size_t number_of_nodes, size_t seed) {
    return interruptible([=](auto*) { return VFC::make_torus_knot(p, q, number_of_nodes, seed); });
  });
  module.def("closed_braid", [](const std::vector<int>& word, size_t number_of_nodes, size_t seed) {
    return interruptible(
        [&](auto*) { return VFC::make_closed_braid(word, number_of_nodes, seed); });
  });
  module.def("hard_unknot", [](size_t number_of_nodes, size_t moves, size_t seed) {
    return interruptible(
        [=](auto*) { return VFC::make_hard_unknot(number_of_nodes, moves, seed); });
  });
  module.def("random_polygon", [](size_t number_of_nodes, size_t seed) {
    return interruptible([=](auto*) { return VFC::make_random_polygon(number_of_nodes, seed); });
  });
}

} // namespace vfc_python
