// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/guard_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>
#include <CGAL/Volume_filling_curves/medial_radii.h>
#include <CGAL/Volume_filling_curves/simplify_curves.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// Functions that have no status end by an exception if the progress asks them to, from the first
// moment on; and so do the loops in which they spend their time. A clock decides nothing here.
namespace test_interrupted_functions {

using namespace CGAL::Volume_filling_curves;
using guard_test::contents;
using internal::Run_stopped;
using internal::Run_watch;
using Network = Curve_network_3<>;
using Traits = Network::Traits;
using Ball = Ball_domain_3<>;
using Samples = Domain_samples_3<Traits, Ball>;
using Progress = std::function<bool(const Run_progress&)>;

struct Filled_ball
{
  Network curve =
      make_closed_braid(CGAL::Volume_filling_curves::parse_braid_word("1 -2 1 -2"), 300, 0, 3);
  Ball ball{Network::Point_3(0, 0, 0), 10};
  Samples samples{ball, 2000};
  std::vector<double> distances = sample_distances(curve, samples);
};

// Each function with its name.
std::vector<std::pair<std::string, std::function<void(const Progress&)>>> functions(
    const Filled_ball& b)
{
  namespace p = parameters;
  const auto& c = b.curve;
  return {
      {"min_clearance", [&](const auto& f) { (void)min_clearance(c, 0.1, p::progress(f)); }},
      {"thickness", [&](const auto& f) { (void)polygonal_thickness(c, p::progress(f)); }},
      {"ropelength", [&](const auto& f) { (void)ropelength(c, p::progress(f)); }},
      {"crossings", [&](const auto& f) { (void)average_crossing_number(c, p::progress(f)); }},
      {"linking", [&](const auto& f) { (void)linking_matrix(c, p::progress(f)); }},
      {"measure", [&](const auto& f) { (void)measure(c, 0.1, p::progress(f)); }},
      {"default_thickness", [&](const auto& f) { (void)default_thickness(c, 8, p::progress(f)); }},
      {"mean", [&](const auto& f) { (void)mean_medial_radius(c, 1, 8, p::progress(f)); }},
      {"radii", [&](const auto& f) { (void)medial_radii(c, 1, 8, p::progress(f)); }},
      {"least", [&](const auto& f) { (void)min_medial_radii(c, 1, 8, p::progress(f)); }},
      {"distances", [&](const auto& f) { (void)sample_distances(c, b.samples, p::progress(f)); }},
      {"regions",
       [&](const auto& f) { (void)empty_regions(c, b.samples, b.distances, 0.1, p::progress(f)); }},
      {"containment", [&](const auto& f) { (void)containment(c, b.ball, p::progress(f)); }}};
}

TEST(Interrupted_functions, throw_when_they_are_told_to_end_and_ask_no_more)
{
  const Filled_ball ball;
  for(const auto& [name, call] : functions(ball)) {
    int calls = 0;
    const auto end = [&](const Run_progress& progress) {
      EXPECT_EQ(progress.stage, Run_stage::MEASURING);
      ++calls;
      return false;
    };
    EXPECT_THROW(call(end), Run_interrupted) << name;
    EXPECT_EQ(calls, 1) << name;
    EXPECT_NO_THROW(call([](const Run_progress&) { return true; })) << name;
  }
}

TEST(Interrupted_functions, measure_polylines)
{
  const std::vector<Network::Point_3> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
  const auto np = parameters::closure(Closure::IF_REPEATED);
  EXPECT_THROW((void)measure(triangle, 0, np.progress([](const Run_progress&) { return false; })),
               Run_interrupted);
  EXPECT_EQ(measure(triangle, 0, np).component_lengths.size(), 1u);
}

TEST(Interrupted_functions, ask_within_their_loops)
{
  const Filled_ball b;
  const Network two =
      make_closed_braid(CGAL::Volume_filling_curves::parse_braid_word("1 1"), 300, 0, 2);
  Run_watch over(0);
  EXPECT_THROW((void)internal::Least_clearance<Network>(b.curve, 0.1)(&over), Run_stopped);
  EXPECT_THROW((void)internal::Doubly_critical_distance<Network>(b.curve)(1, &over), Run_stopped);
  EXPECT_THROW((void)internal::average_crossing_number(b.curve, 10, &over), Run_stopped);
  EXPECT_THROW((void)internal::Linking_numbers<Network>(two, &over)(), Run_stopped);
  EXPECT_THROW((internal::Default_thickness<Network, CGAL::Sequential_tag>(b.curve, 8, &over)()),
               Run_stopped);
  EXPECT_THROW(
      (void)internal::capped_medial_spheres<CGAL::Parallel_if_available_tag>(b.curve, 1, 8, &over),
      Run_stopped);
  EXPECT_THROW(
      (void)internal::sample_distances<CGAL::Parallel_if_available_tag>(b.curve, b.samples, &over),
      Run_stopped);
  EXPECT_THROW((void)internal::find_containment(b.curve, b.ball, &over), Run_stopped);
  const auto boundary_distance = [](std::size_t) { return 1.; };
  EXPECT_THROW((void)internal::find_empty_regions(b.curve, b.samples, b.distances,
                                                  boundary_distance, 0.1, &over),
               Run_stopped);
}

// The curve as it is by then is the same knot.
TEST(Interrupted_functions, simplification_leaves_the_other_nodes)
{
  const Network start = make_hard_unknot(300, 30, 1);
  Network curve = start;
  std::size_t calls = 0;
  const auto end = [&](const Run_progress& progress) {
    EXPECT_EQ(progress.stage, Run_stage::SIMPLIFYING);
    ++calls;
    return false;
  };
  EXPECT_EQ(simplify_curves(curve, parameters::progress(end)), 0u);
  EXPECT_EQ(calls, 1u);
  EXPECT_EQ(contents(curve), contents(start));
  EXPECT_GT(simplify_curves(curve, parameters::progress([](const auto&) { return true; })), 0u);
}

TEST(Interrupted_functions, verification_knows_nothing_then)
{
  const Network start = make_hard_unknot(200, 30, 1);
  Network curve = start;
  Isotopy_certificate certificate;
  simplify_curves(curve, parameters::certificate(std::ref(certificate)));
  const Ball ball(Network::Point_3(0, 0, 0), 1000);
  int calls = 0;
  const auto end = parameters::progress([&](const Run_progress& progress) {
    EXPECT_EQ(progress.stage, Run_stage::VERIFYING);
    ++calls;
    return false;
  });
  EXPECT_THROW((void)verify_certificate(certificate, start, curve, end), Run_interrupted);
  EXPECT_THROW((void)verify_certificate(certificate, start, curve, ball, end), Run_interrupted);
  EXPECT_EQ(calls, 2);
  Run_watch over(0);
  internal::replay::Certificate_verifier verifier(certificate.bytes(), nullptr, &over);
  EXPECT_THROW(internal::verdict_of(verifier, start, curve), Run_stopped);
  const auto go_on = parameters::progress([](const Run_progress&) { return true; });
  EXPECT_TRUE(verify_certificate(certificate, start, curve, go_on).is_valid);
  EXPECT_TRUE(verify_certificate(certificate, start, curve, ball, go_on).is_valid);
}

} // namespace test_interrupted_functions
