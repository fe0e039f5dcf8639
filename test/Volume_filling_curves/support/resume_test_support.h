// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_RESUME_TEST_SUPPORT_H
#define VFC_TEST_RESUME_TEST_SUPPORT_H

#include <CGAL/Volume_filling_curves/Run_state.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Default_curve_flow_visitor.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

// Runs that are interrupted and resumed, and what they must have in common with those that are not.
namespace resume_test {

using CGAL::Volume_filling_curves::Isotopy_certificate;
using CGAL::Volume_filling_curves::Run_checkpoint;
using CGAL::Volume_filling_curves::Run_state;

// Ends a run after some steps, and some looks of a search.
struct Interruption : CGAL::Volume_filling_curves::Default_curve_flow_visitor
{
  static constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

  std::size_t steps = never, looks = never;

  template <typename Flow>
  bool go_further(const Flow& flow) const
  {
    return flow.statistics().iterations < steps;
  }

  bool on_search(const CGAL::Volume_filling_curves::Search_progress&) { return looks-- > 0; }
};

// All that a run leaves behind, but for the time that it took.
template <typename Network, typename Result>
struct Outcome
{
  Network curve;
  Result result;
  Isotopy_certificate certificate;
  Run_state state; // the last one
};

using Node = std::tuple<double, double, double, std::size_t, bool, std::size_t>;

// everything that is known of the nodes
template <typename Network>
std::vector<Node> nodes(const Network& curve)
{
  std::vector<Node> nodes;
  for(const std::size_t v : curve.nodes()) {
    const auto& p = curve.point(v);
    nodes.emplace_back(p.x(), p.y(), p.z(), curve.origin(v), curve.is_pinned(v),
                       curve.component(v));
  }
  return nodes;
}

template <typename Outcome>
void expect_same(const Outcome& a, const Outcome& b)
{
  EXPECT_EQ(nodes(a.curve), nodes(b.curve));
  EXPECT_EQ(a.certificate.bytes(), b.certificate.bytes());
  EXPECT_EQ(a.result.status, b.result.status);
  EXPECT_EQ(a.result.thickness, b.result.thickness);
  EXPECT_EQ(a.result.gradient_norm, b.result.gradient_norm);
  EXPECT_EQ(a.result.statistics.iterations, b.result.statistics.iterations);
  EXPECT_EQ(a.result.statistics.certified_changes, b.result.statistics.certified_changes);
  EXPECT_EQ(a.result.statistics.refused_changes, b.result.statistics.refused_changes);
}

// Runs, with a certificate and the states that are offered. `Run` takes a curve, parameters and a
// visitor.
template <typename Network, typename Parameters, typename Run>
auto run_from(const Run& run,
              Network curve,
              Parameters parameters,
              const Run_state& state,
              Interruption visitor)
{
  using Result = decltype(run(curve, parameters, visitor));
  Outcome<Network, Result> outcome;
  parameters.certificate = &outcome.certificate;
  parameters.resume_from = &state;
  parameters.checkpoint = [&](const Run_checkpoint& checkpoint) {
    if(checkpoint.is_last()) outcome.state = checkpoint.state();
  };
  outcome.result = run(curve, parameters, visitor);
  outcome.curve = std::move(curve);
  return outcome;
}

// Interrupts a run as each of the visitors wants, one after the other, and resumes it each time,
// through the bytes of the state.
template <typename Network, typename Parameters, typename Run>
auto run_in_pieces(const Run& run,
                   const Network& curve,
                   const Parameters& parameters,
                   const std::vector<Interruption>& interruptions)
{
  Run_state state;
  for(const Interruption& interruption : interruptions) {
    const Run_state next = run_from(run, curve, parameters, state, interruption).state;
    EXPECT_FALSE(next.is_empty());
    state = Run_state(next.bytes());
  }
  return run_from(run, curve, parameters, state, {});
}

} // namespace resume_test

#endif // VFC_TEST_RESUME_TEST_SUPPORT_H
