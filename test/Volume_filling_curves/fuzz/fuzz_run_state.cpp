// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Lets runs resume from states in which numbers were replaced and removed, and whose checksums are
// right: they refuse them, or end with an embedded curve. Build with
// clang++ -fsanitize=fuzzer,address,undefined.

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Volume_filling_curves;
using Network = Curve_network_3<>;

// Takes a trefoil of a few edges, whose ends are open in run 1, and resumes a run: a search in run
// 2, one with a certificate in run 3. Returns the last state.
Run_state resume(std::size_t run, std::size_t iterations, const Run_state& former)
{
  const Network knot = make_torus_knot(2, 3, 30);
  std::vector<Network::Point_3> points(knot.points().begin(), knot.points().end());
  if(run != 1) points.push_back(points.front());
  Network curve(std::vector{points});
  curve.pin_ends();
  Run_state state;
  Isotopy_certificate certificate;
  Untangling_parameters parameters;
  parameters.strategy = run == 2 ? Untangling_strategy::SEARCH : Untangling_strategy::FLOW;
  parameters.thickness = 0.5;
  if(run == 3) parameters.certificate = &certificate;
  parameters.number_of_iterations = run == 2 ? 0 : iterations; // a search is not saved halfway
  parameters.time_limit = 0.1;
  parameters.resume_from = &former;
  parameters.checkpoint = [&](const Run_checkpoint& moment) { state = moment.state(); };
  try {
    untangle(curve, parameters);
  } catch(const Run_state_error&) {
  }
  if(!is_embedded(curve)) std::abort();
  return state;
}

// Replaces or removes eight bytes at the position that each pair of bytes encodes. The fingerprint,
// which says whose state it is, stays.
Run_state forged(const Run_state& state, const std::uint8_t* data, std::size_t size)
{
  constexpr std::size_t width = 8;
  std::string fingerprint, body(state.body());
  internal::Byte_archive{body}(fingerprint);
  const std::size_t begin = sizeof(std::size_t) + fingerprint.size();
  for(; size >= 2 + width && body.size() >= begin + width; size -= 2 + width, data += 2 + width) {
    const std::size_t place = data[0] + 256 * std::size_t(data[1] & 127);
    const std::string number(reinterpret_cast<const char*>(data + 2), width);
    body.replace(begin + width * (place % ((body.size() - begin) / width)), width,
                 data[1] < 128 ? number : std::string());
  }
  return Run_state::sealed(body);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if(size < 1) return 0;
  const std::size_t run = data[0] % 4;
  static Run_state states[4];
  if(states[run].is_empty()) states[run] = resume(run, 1, {});
  resume(run, 2, forged(states[run], data + 1, size - 1));
  return 0;
}
