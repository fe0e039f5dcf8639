// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Run_observer.h"
#include "bindings.h"
#include "options.h"
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
    const Interpreter_unlock unlock;
    identity = VFC::identify(curve, VFC::parameters::progress(std::ref(observer)));
  }
  return to_python(identity);
}

// Of a curve that is one open chain.
py::dict identify_chain(const Curve& chain, const py::dict& options, const py::object& progress)
{
  const auto given = parameters_of<VFC::Chain_parameters>(options);
  Run_observer observer(progress);
  VFC::Chain_identity identity;
  {
    const Interpreter_unlock unlock;
    identity = VFC::identify_chain(chain, 0,
                                   VFC::parameters::closures(given.closures)
                                       .random_seed(given.random_seed)
                                       .find_core(given.find_core)
                                       .stride(given.stride)
                                       .progress(std::ref(observer)));
  }
  return to_python(identity);
}

} // namespace

void bind_identification(py::module_& module)
{
  module.def("identify", &identify);
  module.def("identify_chain", &identify_chain);
}

} // namespace vfc_python
