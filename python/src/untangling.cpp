// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "bindings.h"
#include "options.h"
#include "results.h" // generated

#include <CGAL/Volume_filling_curves/untangle.h>

#include <functional>

namespace vfc_python {

namespace {

// Replaces the curve by the result.
py::dict untangle(Curve& curve,
                  const py::dict& options,
                  VFC::Isotopy_certificate* certificate,
                  const py::object& progress)
{
  auto parameters = parameters_of<VFC::Untangling_parameters>(options);
  Run_observer observer(progress);
  parameters.progress = std::ref(observer);
  parameters.certificate = certificate;
  VFC::Untangling_result result;
  {
    const py::gil_scoped_release unlock;
    result = VFC::untangle<CGAL::Parallel_if_available_tag>(curve, parameters);
  }
  return to_python(result);
}

} // namespace

void bind_untangling(py::module_& module)
{
  module.def("untangle", &untangle);
}

} // namespace vfc_python
