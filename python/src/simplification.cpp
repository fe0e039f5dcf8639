// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "bindings.h"
#include "options.h"

#include <CGAL/Volume_filling_curves/simplify_curves.h>

#include <cstddef>
#include <functional>

namespace vfc_python {

namespace {

// Replaces the curve by the result, and returns how many nodes were removed.
std::size_t simplify(Curve& curve,
                     const py::dict& options,
                     VFC::Isotopy_certificate* certificate,
                     const py::object& progress)
{
  auto parameters = parameters_of<VFC::Simplification_parameters>(options);
  Run_observer observer(progress);
  parameters.progress = std::ref(observer);
  parameters.certificate = certificate;
  const Interpreter_unlock unlock;
  return VFC::simplify_curves(curve, parameters);
}

} // namespace

void bind_simplification(py::module_& module)
{
  module.def("simplify", &simplify);
}

} // namespace vfc_python
