// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "files/Output_files.h"
#include "identification/Identification_watch.h"
#include "identification/identify_curves.h"
#include "options/numbers.h"
#include "pictures/fingerprint_pictures.h"
#include "reports/chain_report.h"
#include "session/Session.h"
#include "session/errors.h"

#include <CGAL/Volume_filling_curves/identify.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>

namespace vfc {

namespace curves = CGAL::Volume_filling_curves;

namespace {

std::size_t number_of_nodes(const Curve& curve, std::size_t component)
{
  return curve.first_node(component + 1) - curve.first_node(component);
}

std::string extension(const std::string& file)
{
  return std::filesystem::path(file).extension().string();
}

void write_fingerprint(const std::string& file, const curves::Chain_identity& identity)
{
  const std::string kind = extension(file);
  Output_files::write(file, kind == ".csv"   ? fingerprint_csv(identity)
                            : kind == ".svg" ? svg_fingerprint(identity)
                                             : png_fingerprint(identity));
}

// The stride of a fingerprint, or 0 if none is wanted.
std::size_t stride(const Identify_options& options, std::size_t nodes)
{
  constexpr std::size_t default_number_of_strides = 60;
  if(options.fingerprint.empty()) return 0;
  return options.chain.stride > 0 ? options.chain.stride
                                  : (std::max<std::size_t>)(1, nodes / default_number_of_strides);
}

} // namespace

void check_fingerprint(const std::string& file)
{
  const std::string kind = extension(file);
  if(kind != ".svg" && kind != ".png" && kind != ".csv")
    throw Usage_error("--fingerprint: " + file + ": fingerprints are .svg, .png or .csv files");
}

std::string identify_chains(Session& session,
                            const Curve& curve,
                            const std::string& file,
                            const Identify_options& options)
{
  if(!options.codes.empty()) throw Usage_error("--codes: " + file + ": an open chain has no code");
  const std::size_t n = curve.number_of_components();
  if(n > 1 && !options.fingerprint.empty())
    throw Usage_error("--fingerprint: " + file + ": has " + counted(n, "chain") + ", not one");
  Report& report = session.report();
  Identification_watch watch(session, file, options.time_limit);
  std::string text;
  for(std::size_t c = 0; c < n; ++c) {
    const std::size_t nodes = number_of_nodes(curve, c);
    const curves::Chain_identity identity = watch([&](const auto& progress) {
      return curves::identify_chain<CGAL::Parallel_if_available_tag>(
          curve, c,
          curves::parameters::closures(options.chain.closures)
              .random_seed(options.chain.random_seed)
              .find_core(options.chain.find_core)
              .stride(stride(options, nodes))
              .progress(progress));
    });
    report["chains"].push_back(chain_report(identity, nodes));
    const std::string number = n > 1 ? "chain " + std::to_string(c + 1) + ": " : "";
    text += file + ": " + number + chain_text(report["chains"].back()) + '\n';
    if(!options.fingerprint.empty()) write_fingerprint(options.fingerprint, identity);
  }
  report["seed"] = options.chain.random_seed;
  if(n == 1) report["name"] = report["chains"][0]["name"];
  session.end_stage("identifying");
  return text;
}

} // namespace vfc
