// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/archetype_traits.h"
#include "support/untangle_test_support.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <vector>

// Changes that must not affect the result: a second run, threads, another traits class; and changes
// that affect it in a known way: scaling, moving, mirroring.
namespace test_untangle_invariance {

using namespace untangle_test;
using archetypes::Archetype;
using CGAL::Volume_filling_curves::make_hard_unknot;

std::vector<Network> some_curves()
{
  Random random(3);
  std::vector<Network> curves = {make_hard_unknot(80, 2000, 4), tangled(braid("1 1 1", 60), 2, 500),
                                 braid("1 -2 1 -2 -2", 80), junctions_and_ends(10, random)};
  curves.back().pin_ends();
  return curves;
}

constexpr int enough = 15; // iterations

template <typename Tag = CGAL::Sequential_tag, typename Network>
std::vector<double> result_of(Network curve, double scale = 1)
{
  const Untangling_result result = untangle<Tag>(curve, parameters::number_of_iterations(enough));
  std::vector<double> all = {double(result.status), double(result.link), result.thickness / scale,
                             result.gradient_norm, double(result.statistics.iterations)};
  Vector_field x = internal::coordinates(curve);
  x /= scale;
  all.insert(all.end(), x.data(), x.data() + x.size());
  return all;
}

TEST(Untangle, gives_the_same_bits_again)
{
  for(const Network& curve : some_curves()) EXPECT_EQ(result_of(curve), result_of(curve));
}

TEST(Untangle, gives_the_same_bits_in_parallel)
{
#ifdef CGAL_LINKED_WITH_TBB
  for(const Network& curve : some_curves())
    EXPECT_EQ(result_of<CGAL::Parallel_tag>(curve), result_of(curve));
#else
  GTEST_SKIP() << "TBB is missing";
#endif
}

TEST(Untangle, scales_by_powers_of_two_bit_by_bit)
{
  for(const Network& curve : some_curves())
    for(int exponent : {-50, 1}) {
      const double scale = std::ldexp(1., exponent);
      EXPECT_EQ(result_of(transformed(curve, scale), scale), result_of(curve));
    }
}

// The archetype decides with rational numbers: slow, so a small curve.
TEST(Untangle, takes_every_model_of_the_traits)
{
  using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  const Network knot = braid("1 1 1", 40);
  const auto in = [&](const auto& traits) {
    using Other = Curve_network_3<std::decay_t<decltype(traits)>>;
    std::vector<typename Other::Point_3> points;
    Edges edges;
    for(std::size_t v = 0; v < 40; ++v)
      points.push_back(internal::to_point(internal::to_vector(knot.point(v)), traits));
    for(std::size_t v = 0; v < 40; ++v) edges.push_back({v, (v + 1) % 40});
    return Other(points, edges, traits);
  };
  const std::vector<double> expected = result_of(knot);
  EXPECT_EQ(result_of(in(Archetype(0))), expected);
  EXPECT_EQ(result_of(in(CGAL::Volume_filling_curves::Curve_flow_traits_3<Exact_kernel>())),
            expected);
  auto link = in(Archetype(0));
  CGAL::Volume_filling_curves::Isotopy_guard_3 guard(link);
  EXPECT_EQ(CGAL::Volume_filling_curves::Curve_flow_3(guard).medial_spheres(3).size(), 16u);
}

TEST(Untangle, finds_the_same_wherever_the_curve_stands)
{
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized().toRotationMatrix();
  const Eigen::Matrix3d mirror = Eigen::Vector3d(1, 1, -1).asDiagonal();
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  for(const Network& curve : {some_curves()[0], some_curves()[1]}) {
    Network reference = curve;
    const Untangling_result expected = untangle(reference);
    for(Network moved : {transformed(curve, 1, turn), transformed(curve, 1, mirror),
                         transformed(curve, 1, identity, {1e4, -2e4, 3e4}),
                         transformed(curve, 1e-5, turn), transformed(curve, 12345, turn)}) {
      const auto invariants = invariants_of(moved);
      const Untangling_result result = untangle(moved);
      EXPECT_EQ(result.status, expected.status);
      EXPECT_EQ(invariants_of(moved), invariants);
    }
  }
}

// Nodes numbered along the other direction, or from another one on.
TEST(Untangle, does_not_depend_on_where_a_curve_starts)
{
  const Network knot = tangled(braid("-1 -1 -1", 60), 5, 500);
  const std::size_t n = knot.number_of_nodes();
  Polygon shifted;
  for(std::size_t v = 0; v < n; ++v)
    shifted.push_back(internal::to_vector(knot.point((2 * n - v + 17) % n)));
  Network curve = internal::closed_network({shifted}), other = knot;
  EXPECT_EQ(untangle(curve).status, untangle(other).status);
}

} // namespace test_untangle_invariance
