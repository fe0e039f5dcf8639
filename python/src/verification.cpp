// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Run_observer.h"
#include "bindings.h"
#include "results.h" // generated

#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <functional>
#include <string>

namespace vfc_python {

namespace {

py::dict verify(const VFC::Isotopy_certificate& certificate,
                const Curve& start,
                const Curve& end,
                const py::object& progress)
{
  Run_observer observer(progress);
  VFC::Certificate_verdict verdict;
  {
    const py::gil_scoped_release unlock;
    verdict = VFC::verify_certificate(certificate, start, end,
                                      VFC::parameters::progress(std::ref(observer)));
  }
  return to_python(verdict);
}

} // namespace

void bind_verification(py::module_& module)
{
  using VFC::Isotopy_certificate;
  py::class_<Isotopy_certificate>(module, "Certificate")
      .def(py::init<>())
      .def(py::init([](const py::bytes& bytes) { return Isotopy_certificate(std::string(bytes)); }))
      .def("bytes", [](const Isotopy_certificate& c) { return py::bytes(c.bytes()); });
  module.def("verify", &verify);
}

} // namespace vfc_python
