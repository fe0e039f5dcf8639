// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Run_observer.h"
#include "bindings.h"
#include "results.h" // generated

#include <CGAL/Volume_filling_curves/identify.h>

#include <functional>

namespace vfc_python {

namespace {

py::dict identify(const Curve& curve, const py::object& progress)
{
  Run_observer observer(progress);
  VFC::Link_identity identity;
  {
    const py::gil_scoped_release unlock;
    identity = VFC::identify(curve, VFC::parameters::progress(std::ref(observer)));
  }
  return to_python(identity);
}

} // namespace

void bind_identification(py::module_& module)
{
  module.def("identify", &identify);
}

} // namespace vfc_python
