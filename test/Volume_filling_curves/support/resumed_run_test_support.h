// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_RESUMED_RUN_TEST_SUPPORT_H
#define VFC_TEST_RESUMED_RUN_TEST_SUPPORT_H

#include "support/untangle_test_support.h"

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

// Runs that are interrupted, and resume from a state.
namespace resumed_run_test {

using namespace untangle_test;
using namespace CGAL::Volume_filling_curves;
using Point = Network::Point_3;
using Parameters = Untangling_parameters;
using Filling = Filling_parameters<Point>;

constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

// Ends a run at a limit of iterations, when the visitor has been asked some times whether a step or
// a search is to go on, or at the first report of a stage.
struct Interruption : Default_curve_flow_visitor
{
  Interruption(std::size_t n = never, std::size_t k = never) : iterations(n), answers(k) {}
  Interruption(Run_stage s) : Interruption() { stage = s; }

  std::size_t iterations, answers;
  std::optional<Run_stage> stage;

  template <typename Flow>
  bool go_further(const Flow&)
  {
    return answers > 0 && answers-- > 0;
  }

  bool on_search(const Search_progress&) { return answers > 0 && answers-- > 0; }
};

// All results of a run, except its time and its last state.
struct Outcome
{
  std::vector<double> numbers;
  Run_state state;
};

template <typename Run, typename P>
Outcome run_from(const Run& run, Network curve, P p, const Run_state& state, Interruption visitor)
{
  Outcome outcome;
  Isotopy_certificate certificate;
  p.certificate = &certificate;
  p.resume_from = &state;
  if(visitor.iterations != never) p.number_of_iterations = visitor.iterations;
  p.progress = [&](const Run_progress& progress) { return progress.stage != visitor.stage; };
  p.checkpoint = [&](const Run_checkpoint& checkpoint) {
    if(checkpoint.is_last) outcome.state = Run_state(checkpoint.state().bytes());
  };
  const auto result = run(curve, p, visitor);
  const auto& done = result.statistics;
  const auto note = [&](auto... numbers) {
    (outcome.numbers.push_back(static_cast<double>(numbers)), ...);
  };
  for(const std::size_t v : curve.nodes()) {
    const Point& x = curve.point(v);
    note(x.x(), x.y(), x.z(), curve.origin(v), curve.is_pinned(v), curve.is_free(v),
         curve.component(v));
  }
  for(const Curve_origin& origin : curve_origins(curve)) note(origin.parameter);
  note(done.iterations, done.certified_changes, done.refused_changes);
  note(result.status, result.thickness, result.gradient_norm);
  for(const char byte : certificate.bytes()) note(byte);
  return outcome;
}

inline const auto untangling = [](Network& curve, const Parameters& parameters, auto visitor) {
  return untangle(curve, parameters, visitor);
};

inline Parameters by(Untangling_strategy strategy, double thickness = 0)
{
  Parameters parameters;
  parameters.strategy = strategy;
  parameters.thickness = thickness;
  return parameters;
}

template <typename Domain>
auto filling(const Domain& domain)
{
  return [&domain](Network& curve, const Filling& parameters, auto visitor) {
    return fill(curve, domain, parameters, visitor);
  };
}

inline Filling with_sharp_bends()
{
  Filling parameters;
  parameters.round_bends = false;
  return parameters;
}

} // namespace resumed_run_test

#endif // VFC_TEST_RESUMED_RUN_TEST_SUPPORT_H
