// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The core of the live page, compiled natively, for its tests:
//   native steps IN.obj N OUT.obj                    makes N steps
//   native search IN.obj SEED OUT.obj                searches to the end
//   native fill IN.off THICKNESS BEND RATIO OUT.obj  fills a domain
//   native linking IN.obj                            writes the linking number of two rings
//   native verify CERTIFICATE START END              succeeds if the certificate is valid

#include "Live_curve.h"
#include "Live_filling.h"

#include <CGAL/Volume_filling_curves/IO/curve_network.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <cstddef>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace {

namespace VFC = CGAL::Volume_filling_curves;

VFC::Curve_network_3<> read(const std::string& file)
{
  VFC::Curve_network_3<> curve;
  if(!CGAL::IO::read_curve_network(file, curve)) throw std::runtime_error("cannot read " + file);
  return curve;
}

int make_steps(const std::string& in, int n, const std::string& out)
{
  vfc_page::Live_curve live(read(in));
  for(int k = 0; k < n; ++k) live.step();
  return CGAL::IO::write_curve_network(out, live.curve()) ? 0 : 1;
}

int search(const std::string& in, std::size_t seed, const std::string& out)
{
  vfc_page::Live_curve live(read(in));
  live.begin_search(seed);
  while(live.search(1)) {
  }
  return CGAL::IO::write_curve_network(out, live.curve()) ? 0 : 1;
}

int fill(const std::string& in, const vfc_page::Filling_settings& settings, const std::string& out)
{
  vfc_page::Live_filling live(vfc_page::read_surface(in));
  live.fill(settings, {[] {}, [](const VFC::Run_progress&) {}, [](const VFC::Run_checkpoint&) {}});
  return CGAL::IO::write_curve_network(out, live.curve()) ? 0 : 1;
}

int write_linking_number(const std::string& in)
{
  std::cout << VFC::linking_matrix(read(in))[0][1] << '\n';
  return 0;
}

int verify(const std::string& file, const std::string& start, const std::string& end)
{
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  const auto verdict =
      VFC::verify_certificate(VFC::Isotopy_certificate(content.str()), read(start), read(end));
  std::cout << verdict.message << '\n';
  return verdict.is_valid ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
  const std::string command = argc > 1 ? argv[1] : "";
  if(command == "steps" && argc == 5) return make_steps(argv[2], std::stoi(argv[3]), argv[4]);
  if(command == "search" && argc == 5) return search(argv[2], std::stoul(argv[3]), argv[4]);
  if(command == "fill" && argc == 7)
    return fill(argv[2], {std::stod(argv[3]), std::stod(argv[4]), std::stod(argv[5])}, argv[6]);
  if(command == "linking" && argc == 3) return write_linking_number(argv[2]);
  if(command == "verify" && argc == 5) return verify(argv[2], argv[3], argv[4]);
  return 1;
}
