// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "files/certificates.h"

#include "files/Output_files.h"
#include "files/curve_files.h"
#include "files/polygon_files.h"
#include "files/read_finite_file.h"
#include "repair/obstacles.h"
#include "session/Session.h"
#include "session/errors.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <functional>
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
  const std::error_code error = read_finite_file(file, content);
  if(error) throw std::invalid_argument(error.message());
  return curves::Isotopy_certificate(std::move(content));
}

Curve read_end(Session& session, const std::string& file, const Curve_reading& reading)
{
  Curve_and_defects read = read_curve_and_defects(file, reading);
  if(!read.is_valid) throw Input_error(std::move(read.defects), "a valid curve");
  session.report()["nodes_end"] = read.curve.number_of_nodes();
  session.report()["length_end"] = curves::length(read.curve);
  return std::move(read.curve);
}

// The kind of the defect already states the rejection.
std::string without_first_word(const std::string& sentence)
{
  return sentence.substr(sentence.find(' ') + 1);
}

// Reads the domain and returns a function that verifies a certificate, also with the domain.
std::function<curves::Certificate_verdict(const curves::Isotopy_certificate&)> verifier(
    Session& session, const Certificate_files& files, const Curve& start, const Curve& end)
{
  if(files.domain.empty())
    return [&](const auto& certificate) {
      return curves::verify_certificate(certificate, start, end);
    };
  const auto verify_in = [&start, &end](auto domain) {
    return [&start, &end, domain = std::move(domain)](const auto& certificate) {
      return curves::verify_certificate(certificate, start, end, domain);
    };
  };
  if(is_polygon_file(files.domain)) return verify_in(*read_polygons(session, files.domain).domain);
  Mesh mesh = read_mesh(session, files.domain).mesh;
  add_obstacles(session, mesh, files.obstacles);
  return verify_in(std::move(mesh));
}

bool is_text_file(const std::string& file)
{
  constexpr std::string_view ending = ".txt";
  return file.size() > ending.size() &&
         file.compare(file.size() - ending.size(), ending.size(), ending) == 0;
}

} // namespace

void write_certificate(const std::string& file, const curves::Isotopy_certificate& certificate)
{
  Output_files::write(file, is_text_file(file) ? certificate.text() : certificate.bytes());
}

Defects defects_of_certificate(Session& session,
                               const Certificate_files& files,
                               const Curve_reading& reading)
{
  session.add_input(files.certificate);
  if(!files.domain.empty()) session.add_input(files.domain);
  for(const std::string& obstacle : files.obstacles) session.add_input(obstacle);
  const Curve start = read_curve(session, files.start, reading);
  const Curve end = read_end(session, files.end, reading);
  session.report()["input"] = files.start;
  const auto verify = verifier(session, files, start, end);
  try {
    const curves::Certificate_verdict verdict = verify(read_certificate(files.certificate));
    session.report()["moves_certified"] = verdict.number_of_operations;
    const std::string sentence = verdict.sentence(files.start, files.end, files.domain);
    if(!verdict.is_valid) return {rejection(files.certificate, without_first_word(sentence))};
    session.print_result(sentence + '\n');
    return {};
  } catch(const std::invalid_argument& error) {
    return {rejection(files.certificate, error.what())};
  }
}

} // namespace vfc
