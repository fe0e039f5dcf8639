// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/flow_test_support.h"
#include "support/guard_test_support.h"
#include "support/jones_polynomial.h"
#include "support/knot_invariants.h"
#include "support/shared_curves.h"

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/IO/curve_network.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

// Results for the shared curves; the benchmark run_shared_curves does the same with all of them,
// and with the oracle.
namespace test_long_shared_curves {

using CGAL::Volume_filling_curves::Link_status;
using CGAL::Volume_filling_curves::Untangling_result;
using CGAL::Volume_filling_curves::Untangling_status;
using flow_test::Network;
using flow_test::transformed;
using guard_test::contents;
using knot_test::Loop;
using shared_curves::Known_curve;
namespace internal = CGAL::Volume_filling_curves::internal;

const std::vector<std::string> unknots = {
    "freedman_he_wang", "goeritz", "thistlethwaite", "ochiai1", "ochiai2", "ochiai3", "ochiai4"};
const std::vector<std::string> knot_sets = {"knot128", "trefoil100", "trefoil_hard"};
constexpr std::size_t max_iterations = 450;

class Long_shared_curves : public shared_curves::Shared_data_test
{};

Network read(const std::string& path)
{
  Network curve;
  EXPECT_TRUE(CGAL::IO::read_curve_network(path, curve)) << path;
  curve.pin_ends();
  return curve;
}

Network read_of_paper(const std::string& name)
{
  return read((shared_curves::folder() / "paper" / (name + ".obj")).string());
}

knot_test::Laurent jones_polynomial(const std::vector<Loop>& loops)
{
  return knot_test::jones_polynomial(knot_test::diagram_of(loops));
}

// Moves every coordinate by up to 1e-5 of the box diagonal.
Network jittered(const Network& curve, unsigned seed)
{
  flow_test::Random random(seed);
  const internal::Vector_field x = internal::coordinates(curve);
  const double noise = 1e-5 * (x.colwise().maxCoeff() - x.colwise().minCoeff()).norm();
  std::vector<internal::Vector> points;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    points.push_back(internal::row(x, v) + noise * flow_test::random_point(random));
  flow_test::Edges edges;
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
    edges.push_back({curve.source(e), curve.target(e)});
  return flow_test::network_of(points, edges);
}

Untangling_result flow(Network& curve)
{
  namespace parameters = CGAL::Volume_filling_curves::parameters;
  constexpr auto strategy = CGAL::Volume_filling_curves::Untangling_strategy::FLOW;
  return CGAL::Volume_filling_curves::untangle(curve, parameters::strategy(strategy));
}

TEST_F(Long_shared_curves, unknots_of_the_paper_are_proved_unknotted)
{
  for(const std::string& name : unknots) {
    Network curve = read_of_paper(name);
    const Untangling_result result = flow(curve);
    EXPECT_EQ(result.status, Untangling_status::UNKNOTTED) << name;
    EXPECT_LE(result.statistics.iterations, max_iterations) << name;
  }
}

TEST_F(Long_shared_curves, trefoil_of_the_paper_becomes_tight)
{
  Network curve = read_of_paper("trefoil0001");
  const knot_test::Invariants expected = knot_test::invariants_of(knot_test::loops_of(curve));
  const Untangling_result result = flow(curve);
  EXPECT_EQ(result.status, Untangling_status::CONVERGED);
  EXPECT_LE(result.statistics.iterations, max_iterations);
  EXPECT_EQ(knot_test::invariants_of(knot_test::loops_of(curve)), expected);
  EXPECT_EQ(std::abs(expected.signature), 2);
  EXPECT_EQ(expected.determinant, 3u);
}

TEST_F(Long_shared_curves, noise_does_not_matter)
{
  for(const std::string& name : unknots)
    for(unsigned seed : {1u, 2u}) {
      Network curve = jittered(read_of_paper(name), seed);
      EXPECT_EQ(flow(curve).status, Untangling_status::UNKNOTTED) << name << ' ' << seed;
    }
}

TEST_F(Long_shared_curves, place_and_size_and_mirror_images_do_not_matter)
{
  Eigen::Matrix3d mirror_image = Eigen::Matrix3d::Identity();
  mirror_image(0, 0) = -1;
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for(const std::string& name : unknots) {
    const Network original = read_of_paper(name);
    Network reference = original;
    flow(reference);
    const internal::Vector far_away(3e4, -2e4, 1e4);
    const auto expect_same = [&](Network curve, double scale) {
      EXPECT_EQ(flow(curve).status, Untangling_status::UNKNOTTED) << name;
      const double expected = scale * CGAL::Volume_filling_curves::length(reference);
      EXPECT_NEAR(CGAL::Volume_filling_curves::length(curve), expected, 0.02 * expected) << name;
    };
    expect_same(transformed(original, 1, mirror_image), 1);
    expect_same(transformed(original, 1, rotation), 1);
    expect_same(transformed(original, 1e-3), 1e-3);
    expect_same(transformed(original, 1, rotation, far_away), 1);
  }
}

TEST_F(Long_shared_curves, powers_of_two_scale_every_bit)
{
  constexpr double factor = 1024;
  for(const char* name : {"freedman_he_wang", "ochiai4", "trefoil0001"}) {
    Network curve = read_of_paper(name), scaled = transformed(curve, factor);
    flow(curve);
    flow(scaled);
    EXPECT_EQ(contents(transformed(curve, factor)), contents(transformed(scaled, 1))) << name;
  }
}

TEST_F(Long_shared_curves, knots_become_tight_and_simple_and_keep_their_types)
{
  const std::vector<Known_curve> knots = shared_curves::known_curves(knot_sets);
  ASSERT_EQ(knots.size(), 236u);
  std::vector<double> ropelengths; // of trefoils
  for(std::size_t k = 0; k < knots.size(); k += 8) {
    const Known_curve& knot = knots[k];
    Network curve = read(knot.path());
    const Untangling_result result = flow(curve);
    EXPECT_EQ(result.status,
              knot.type == "0_1" ? Untangling_status::UNKNOTTED : Untangling_status::CONVERGED)
        << knot.file;
    EXPECT_EQ(jones_polynomial(knot_test::loops_of(curve)), knot.jones) << knot.file;
    if(knot.type == "0_1") continue;
    EXPECT_LT(CGAL::Volume_filling_curves::average_crossing_number(curve), 3 * knot.crossing_number)
        << knot.file;
    if(knot.type == "3_1") ropelengths.push_back(CGAL::Volume_filling_curves::ropelength(curve));
  }
  ASSERT_GE(ropelengths.size(), 13u);
  std::sort(ropelengths.begin(), ropelengths.end());
  const double median = ropelengths[ropelengths.size() / 2];
  EXPECT_GT(ropelengths.front(), 0.8 * median);
  EXPECT_LT(ropelengths.back(), 1.2 * median);
}

TEST_F(Long_shared_curves, links_stay_linked_as_they_are)
{
  for(const Known_curve& link : shared_curves::known_curves({"links"})) {
    Network curve = read(link.path());
    const std::vector<Loop> start = knot_test::loops_of(curve);
    EXPECT_EQ(CGAL::Volume_filling_curves::linking_matrix(curve), link.linking_matrix);
    const Untangling_result result = flow(curve);
    const std::vector<Loop> end = knot_test::loops_of(curve);
    EXPECT_EQ(result.status, Untangling_status::CONVERGED) << link.file;
    EXPECT_EQ(CGAL::Volume_filling_curves::linking_matrix(curve), link.linking_matrix) << link.file;
    const bool is_linked = knot_test::linking_numbers(knot_test::diagram_of(end)) !=
                           std::vector<std::vector<int>>(end.size(), std::vector<int>(end.size()));
    EXPECT_EQ(result.link, is_linked ? Link_status::LINKED : Link_status::UNDECIDED) << link.file;
    ASSERT_EQ(start.size(), end.size());
    for(std::size_t c = 0; c < end.size(); ++c)
      EXPECT_EQ(knot_test::invariants_of({end[c]}), knot_test::invariants_of({start[c]}))
          << link.file << ", component " << c;
  }
}

TEST_F(Long_shared_curves, open_arcs_keep_their_ends_and_types)
{
  const auto path_of = [](const Network& curve) {
    std::vector<std::vector<Network::Point_3>> polylines;
    CGAL::Volume_filling_curves::curve_network_to_polylines(curve, std::back_inserter(polylines));
    Loop path;
    for(const Network::Point_3& p : polylines.at(0)) path.push_back({p.x(), p.y(), p.z()});
    return path;
  };
  for(const Known_curve& arc : shared_curves::known_curves({"open_arcs"})) {
    Network curve = read(arc.path());
    const Loop start = path_of(curve);
    EXPECT_EQ(flow(curve).status, Untangling_status::CONVERGED) << arc.file;
    const Loop end = path_of(curve);
    EXPECT_EQ(end.front(), start.front()) << arc.file;
    EXPECT_EQ(end.back(), start.back()) << arc.file;
    EXPECT_EQ(jones_polynomial({shared_curves::closed_far_away(end)}), arc.jones) << arc.file;
  }
}

// Data that others made, see the README there: tight already, or so tangled that no search helps.
Network read_real(const std::string& name)
{
  return read((shared_curves::folder() / "real" / "curves" / (name + ".obj")).string());
}

TEST_F(Long_shared_curves, never_get_looser)
{
  for(const std::string name : {"rrS_0.1", "rrS_2.2.1", "rrS_3.1", "rrS_blob", "rrT_4_1"}) {
    Network curve = read_real(name);
    const double before = ropelength(curve);
    const Untangling_result result = untangle(curve);
    EXPECT_NE(result.status, Untangling_status::LIMIT) << name;
    EXPECT_LE(ropelength(curve), before) << name;
  }
}

TEST_F(Long_shared_curves, are_not_searched_for_long)
{
  for(const std::string name : {"rrS_blob", "conf300_R2"}) {
    Network curve = read_real(name);
    const Untangling_result result = untangle(curve);
    EXPECT_EQ(result.status, Untangling_status::CONVERGED) << name;
    EXPECT_EQ(result.searches, 1u) << name;
    EXPECT_LT(result.sweeps, 300u) << name;
  }
}

// 0.1.0 called this tight, with 91 crossings.
TEST_F(Long_shared_curves, are_not_called_tight_on_a_plateau)
{
  namespace parameters = CGAL::Volume_filling_curves::parameters;
  using CGAL::Volume_filling_curves::Untangling_strategy;
  for(const double thickness : {0.0336, 0.05}) {
    Network curve = read_of_paper("ochiai4");
    const Untangling_result result = untangle(curve, parameters::strategy(Untangling_strategy::FLOW)
                                                         .thickness(thickness)
                                                         .number_of_directions(32));
    EXPECT_NE(result.status, Untangling_status::CONVERGED) << thickness;
  }
}

} // namespace test_long_shared_curves
