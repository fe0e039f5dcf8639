// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Domain.h"
#include "Run_observer.h"
#include "bindings.h"
#include "results.h" // generated

#include <CGAL/Volume_filling_curves/arc_spline.h>

#include <functional>
#include <variant>

namespace vfc_python {

namespace {

// Nodes as the points of the input that they were.
void name_points(const Curve& curve, VFC::Arc_spline<Point>& spline)
{
  for(auto& path : spline.paths)
    for(auto& piece : path.pieces) piece.node = curve.origin(piece.node);
  for(VFC::Arc_conflict& conflict : spline.conflicts) {
    conflict.node = curve.origin(conflict.node);
    conflict.other = curve.origin(conflict.other);
  }
}

// The domain may be None.
py::dict arc_spline(const Curve& curve, const Domain* domain, const py::object& progress)
{
  Run_observer observer(progress);
  const auto np = VFC::parameters::progress(std::ref(observer));
  VFC::Arc_spline<Point> result;
  {
    const Interpreter_unlock unlock;
    result = domain == nullptr
                 ? VFC::arc_spline(curve, np)
                 : std::visit([&](const auto& in) { return VFC::arc_spline(curve, in, np); },
                              domain->inside);
  }
  name_points(curve, result);
  return to_python(result);
}

} // namespace

void bind_arcs(py::module_& module)
{
  module.def("arc_spline", &arc_spline);
}

} // namespace vfc_python
