// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "certificates.h"

#include "Output_files.h"
#include "Session.h"
#include "curve_files.h"
#include "errors.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/IO/whole_files.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;

Defect rejection(const std::string& file, const std::string& message)
{
  return {"certificate rejected", file, {}, 0, message};
}

curves::Isotopy_certificate read_certificate(const std::string& file)
{
  std::string content;
  const std::error_code error = curves::internal::read_whole_file(file, content);
  if(error) throw std::invalid_argument(error.message());
  return curves::Isotopy_certificate(std::move(content));
}

Curve read_end(Session& session, const std::string& file, bool is_network)
{
  Curve_and_defects read = read_curve_and_defects(file, is_network);
  if(!read.is_valid) throw Input_error(std::move(read.defects), "a valid curve");
  session.report()["nodes_end"] = read.curve.number_of_nodes();
  session.report()["length_end"] = curves::length(read.curve);
  return std::move(read.curve);
}

bool is_text_file(const std::string& file)
{
  constexpr std::string_view extension = ".txt";
  return file.size() > extension.size() &&
         file.compare(file.size() - extension.size(), extension.size(), extension) == 0;
}

} // namespace

void write_certificate(const std::string& file, const curves::Isotopy_certificate& certificate)
{
  Output_files::write(file, is_text_file(file) ? certificate.text() : certificate.bytes());
}

Defects defects_of_certificate(Session& session,
                               const std::string& certificate,
                               const std::string& start,
                               const std::string& end,
                               bool is_network)
{
  session.add_input(certificate);
  const Curve first = read_curve(session, start, is_network);
  const Curve last = read_end(session, end, is_network);
  try {
    const curves::Certificate_verdict verdict =
        curves::verify_certificate(read_certificate(certificate), first, last);
    session.report()["moves_certified"] = verdict.number_of_operations;
    if(verdict.is_valid) return {};
    const std::string place =
        verdict.operation > 0 ? "operation " + std::to_string(verdict.operation) + ": " : "";
    return {rejection(certificate, place + verdict.message)};
  } catch(const std::invalid_argument& error) {
    return {rejection(certificate, error.what())};
  }
}

} // namespace vfc
