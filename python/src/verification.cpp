// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Domain.h"
#include "Run_observer.h"
#include "bindings.h"
#include "results.h" // generated

#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <functional>
#include <string>
#include <variant>

namespace vfc_python {

namespace {

// Of a mesh the faces count, which the verifier searches by code of its own.
template <typename NamedParameters>
VFC::Certificate_verdict verdict(const VFC::Isotopy_certificate& certificate,
                                 const Curve& start,
                                 const Curve& end,
                                 const Domain* domain,
                                 const NamedParameters& np)
{
  if(domain == nullptr) return VFC::verify_certificate(certificate, start, end, np);
  if(domain->mesh) return VFC::verify_certificate(certificate, start, end, *domain->mesh, np);
  return std::visit(
      [&](const auto& in) { return VFC::verify_certificate(certificate, start, end, in, np); },
      domain->inside);
}

py::dict verify(const VFC::Isotopy_certificate& certificate,
                const Curve& start,
                const Curve& end,
                const Domain* domain,
                const py::object& progress)
{
  Run_observer observer(progress);
  VFC::Certificate_verdict result;
  {
    const Interpreter_unlock unlock;
    result =
        verdict(certificate, start, end, domain, VFC::parameters::progress(std::ref(observer)));
  }
  return to_python(result);
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
