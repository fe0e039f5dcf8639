// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "arrays.h"
#include "bindings.h"

#include <pybind11/stl.h>

namespace vfc_python {

namespace {

// The point of the input that each node was, or -1.
Integers origins_of(const Curve& curve)
{
  Integers result(static_cast<py::ssize_t>(curve.number_of_nodes()));
  auto x = result.mutable_unchecked<1>();
  for(const std::size_t v : curve.nodes()) {
    const std::size_t origin = curve.origin(v);
    x(static_cast<py::ssize_t>(v)) =
        origin == Curve::null_node() ? -1 : static_cast<std::int64_t>(origin);
  }
  return result;
}

} // namespace

void bind_curves(py::module_& module)
{
  py::class_<Curve>(module, "Curve")
      .def(py::init(&curve_of_components))
      .def(py::init(&curve_of_edges))
      .def("pin", &pin)
      .def("pin_ends", &Curve::pin_ends)
      .def("points", &points_of)
      .def("edges", &edges_of)
      .def("offsets", &offsets_of)
      .def("closedness", &closedness_of)
      .def("origins", &origins_of);
}

} // namespace vfc_python
