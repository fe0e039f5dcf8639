// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Domain.h"
#include "bindings.h"
#include "options.h"
#include "results.h" // generated

#include <CGAL/Volume_filling_curves/untangle_in_domain.h>

#include <functional>
#include <stdexcept>
#include <variant>

namespace vfc_python {

namespace {

// The domain may be none.
VFC::Untangling_result result_in(Curve& curve,
                                 const Domain* domain,
                                 const VFC::Untangling_parameters& parameters)
{
  using Tag = CGAL::Parallel_if_available_tag;
  if(domain == nullptr) return VFC::untangle<Tag>(curve, parameters);
  return VFC::untangle<Tag>(curve, std::get<Any_domain>(domain->inside), parameters);
}

// Replaces the curve by the result.
py::dict untangle(Curve& curve,
                  const Domain* domain,
                  const py::dict& options,
                  VFC::Isotopy_certificate* certificate,
                  const py::object& progress)
{
  if(domain != nullptr && !std::holds_alternative<Any_domain>(domain->inside))
    throw std::invalid_argument("curves are untangled in domains in space, not in polygons");
  auto parameters = parameters_of<VFC::Untangling_parameters>(options);
  Run_observer observer(progress);
  parameters.progress = std::ref(observer);
  parameters.certificate = certificate;
  VFC::Untangling_result result;
  {
    const Interpreter_unlock unlock;
    result = result_in(curve, domain, parameters);
  }
  return to_python(result);
}

} // namespace

void bind_untangling(py::module_& module)
{
  module.def("untangle", &untangle);
}

} // namespace vfc_python
