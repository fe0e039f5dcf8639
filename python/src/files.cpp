// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Run_observer.h"
#include "arrays.h"
#include "bindings.h"

#include <CGAL/Volume_filling_curves/IO/curve_network.h>

#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace vfc_python {

namespace {

// std::invalid_argument names the first error, with its line.
Curve curve_in(const std::string& file, bool is_network)
{
  Curve curve;
  std::vector<VFC::Curve_defect> defects;
  const auto junctions = is_network ? VFC::Junctions::ALLOWED : VFC::Junctions::FORBIDDEN;
  if(CGAL::IO::read_curve_network(file, curve, defects, junctions)) return curve;
  for(const VFC::Curve_defect& defect : defects)
    if(VFC::is_error(defect.kind)) throw std::invalid_argument(to_string(defect, file));
  throw std::invalid_argument(file + " is not a valid curve");
}

Curve read(const std::string& file, bool is_network)
{
  return interruptible([&](auto*) { return curve_in(file, is_network); });
}

void write(const std::string& file, const Curve& curve)
{
  std::error_code error;
  {
    const py::gil_scoped_release unlock;
    CGAL::IO::write_curve_network(file, curve, error);
  }
  if(!error) return;
  errno = error.value();
  PyErr_SetFromErrnoWithFilename(PyExc_OSError, file.c_str());
  throw py::error_already_set();
}

} // namespace

void bind_files(py::module_& module)
{
  module.def("read", &read);
  module.def("write", &write);
}

} // namespace vfc_python
