// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Run_observer.h"
#include "arrays.h"
#include "bindings.h"

#include "formats/curve_formats.h"

#include <CGAL/Volume_filling_curves/internal/curve_files/draft_to_network.h>
#include <CGAL/Volume_filling_curves/internal/text/whole_files.h>

#include <pybind11/stl.h>

#include <cerrno>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace vfc_python {

namespace {

namespace internal = VFC::internal;

std::optional<VFC::Closure> closure_of(const std::optional<bool>& is_closed)
{
  if(!is_closed) return std::nullopt;
  return *is_closed ? VFC::Closure::CLOSED : VFC::Closure::OPEN;
}

// The name of a file in a message, which is UTF-8 whatever the bytes of the name are.
std::string shown(const std::string& file)
{
  const Interpreter_lock lock;
  return py::bytes(file).attr("decode")("utf-8", "backslashreplace").cast<std::string>();
}

std::string text_of(const VFC::Curve_defect& defect, const std::string& file)
{
  const bool is_undecided = defect.kind == VFC::Curve_defect_kind::UNDECIDED_CLOSURE;
  return to_string(defect, shown(file)) +
         (is_undecided ? ": give closed=True or closed=False" : "");
}

// std::invalid_argument names the first error, with its line.
Curve curve_in(const std::string& file, bool is_network, const std::optional<bool>& is_closed)
{
  const auto junctions = is_network ? VFC::Junctions::ALLOWED : VFC::Junctions::FORBIDDEN;
  internal::Curve_draft draft =
      internal::read_curve_draft(vfc::curve_formats(), file, junctions, closure_of(is_closed));
  Curve curve;
  std::vector<VFC::Curve_defect> defects;
  if(internal::draft_to_network(draft, curve, defects, junctions)) return curve;
  for(const VFC::Curve_defect& defect : defects)
    if(VFC::is_error(defect.kind)) throw std::invalid_argument(text_of(defect, file));
  throw std::invalid_argument(shown(file) + " is not a valid curve");
}

Curve read(const std::string& file, bool is_network, const std::optional<bool>& is_closed)
{
  return interruptible([&](auto*) { return curve_in(file, is_network, is_closed); });
}

const vfc::Curve_format& format_to_write(const std::string& file)
{
  const auto is_written = [](const vfc::Curve_format& format) { return format.is_written(); };
  const vfc::Curve_format* const format = vfc::curve_format_of(file);
  if(format == nullptr || !is_written(*format))
    throw std::invalid_argument(shown(file) + ": curves are written to " +
                                internal::extensions_text(vfc::curve_formats(), is_written) +
                                " files");
  return *format;
}

std::error_code error_of_writing(const std::string& file, const Curve& curve)
{
  const vfc::Curve_format& format = format_to_write(file);
  if(curve.number_of_edges() == 0) // no format reads it
    throw std::invalid_argument(shown(file) + ": there is no curve to write");
  const internal::Curve_paths paths(curve);
  return internal::write_whole_file(
      file, format.write != nullptr ? format.write(paths) : format.write_with_columns(paths, {}));
}

void write(const std::string& file, const Curve& curve)
{
  std::error_code error;
  {
    const Interpreter_unlock unlock;
    error = error_of_writing(file, curve);
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
