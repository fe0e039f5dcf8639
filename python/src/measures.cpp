// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Run_observer.h"
#include "bindings.h"
#include "results.h" // generated

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/tube_mesh.h>

#include <cstddef>
#include <functional>

namespace vfc_python {

namespace {

py::dict measure(const Curve& curve, double r, const py::object& progress)
{
  Run_observer observer(progress);
  VFC::Curve_measures measures;
  {
    const Interpreter_unlock unlock;
    measures = VFC::measure(curve, r, VFC::parameters::progress(std::ref(observer)));
  }
  return to_python(measures);
}

// The vertices and the faces of the surface.
py::tuple tube(const Curve& curve, double radius, std::size_t number_of_sides)
{
  return arrays_of(interruptible([&](auto*) {
    Mesh mesh;
    VFC::tube_mesh(curve, radius, mesh, VFC::parameters::number_of_sides(number_of_sides));
    return mesh;
  }));
}

} // namespace

void bind_measures(py::module_& module)
{
  module.def("measure", &measure);
  module.def("length", [](const Curve& curve) { return VFC::length(curve); });
  module.def("tube", &tube);
}

} // namespace vfc_python
