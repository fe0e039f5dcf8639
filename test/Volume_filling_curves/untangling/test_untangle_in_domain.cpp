// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/mesh_test_support.h"
#include "support/refusal_of.h"
#include "support/untangle_test_support.h"

#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/untangle_in_domain.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

// Curves that untangle inside of domains, and around obstacles.
namespace test_untangle_in_domain {

using namespace untangle_test;
namespace parameters = CGAL::Volume_filling_curves::parameters;
using CGAL::Volume_filling_curves::Box_domain_3;
using CGAL::Volume_filling_curves::containment;
using CGAL::Volume_filling_curves::Isotopy_certificate;
using CGAL::Volume_filling_curves::untangle;
using CGAL::Volume_filling_curves::Untangling_parameters;
using CGAL::Volume_filling_curves::Untangling_strategy;
using Mesh_domain = CGAL::Volume_filling_curves::Triangle_mesh_domain_3<>;

const Box_domain_3<> box({-1, -1, -1}, {1, 1, 1});

// Free of faces that meet at its middle: between a cube and a square ring around the z-axis in it.
meshes::Soup cube_with_ring()
{
  meshes::Soup ring = meshes::voxels(
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}},
      0.5);
  for(auto& p : ring.points) p = {p.x() - 0.75, p.y() - 0.75, p.z() - 0.25};
  meshes::Soup cube = meshes::cube(6);
  for(auto& p : cube.points) p = {p.x() - 3, p.y() - 3, p.z() - 3};
  return cube + ring.inverted();
}

// A loop through the hole of the ring, around its side at x = 0.5.
Network loop_around_ring()
{
  std::vector<Vector> points;
  for(int k = 0; k < 60; ++k) {
    const double t = 2 * CGAL_PI * k / 60;
    points.push_back({0.5 + 0.5 * std::cos(t), 0.02 * std::sin(3 * t), std::sin(t)});
  }
  return internal::closed_network({points});
}

TEST(Untangle_in_domain, unties_unknots_in_a_box)
{
  for(const std::uint64_t seed : {1u, 2u}) {
    Network curve = tangled(braid("1", 40), seed, 300);
    const Untangling_result result = untangle(curve, box);
    EXPECT_EQ(result.status, Untangling_status::UNKNOTTED);
    EXPECT_TRUE(containment(curve, box).outside_edges.empty());
    EXPECT_EQ(result.searches, 0u);
    EXPECT_GT(result.statistics.certified_changes, 0u);
  }
}

TEST(Untangle_in_domain, certifies_that_the_curve_stayed_inside)
{
  Network curve = tangled(braid("1 1 1", 60), 3, 300);
  const Network start = curve;
  Isotopy_certificate certificate;
  untangle(curve, box, parameters::certificate(std::ref(certificate)).number_of_iterations(30));
  const auto verdict =
      CGAL::Volume_filling_curves::verify_certificate(certificate, start, curve, box);
  EXPECT_TRUE(verdict.is_valid) << verdict.message;
}

// In space it is an unknot and would vanish; by default the run ends with that proof.
TEST(Untangle_in_domain, ends_tight_around_an_obstacle)
{
  const meshes::Mesh mesh = meshes::to_mesh(cube_with_ring());
  Network first = loop_around_ring(), second = first, third = first;
  const auto np = parameters::thickness(0.1).stop_at_proof(false);
  const Untangling_result result = untangle(first, mesh, np);
  EXPECT_EQ(result.status, Untangling_status::UNKNOTTED);
  const double length = internal::total_length(first);
  EXPECT_GT(length, 2.); // that around the side
  EXPECT_LT(length, 3.);
  EXPECT_TRUE(containment(first, Mesh_domain(mesh)).outside_edges.empty());
  untangle(second, Mesh_domain(mesh), np);
  EXPECT_EQ(contents(first), contents(second));
  Untangling_parameters parameters;
  parameters.thickness = 0.1;
  parameters.stop_at_proof = false;
  untangle<CGAL::Parallel_if_available_tag>(third, mesh, parameters);
  EXPECT_EQ(contents(first), contents(third));
}

// There are no closing rays, and strands slip off the ends.
TEST(Untangle_in_domain, is_not_known_to_keep_the_knot_of_an_arc)
{
  Network ring = tangled(braid("1 1 1", 60), 3, 300), arc = ring;
  EXPECT_TRUE(untangle(ring, box).is_closure_kept);
  Polygon points;
  for(const auto& p : arc.points()) points.push_back(internal::to_vector(p));
  arc = path(points);
  arc.pin_ends();
  EXPECT_FALSE(untangle(arc, box).is_closure_kept);
}

TEST(Untangle_in_domain, refuses_curves_outside_and_the_search)
{
  Network curve = loop_around_ring();
  const auto before = contents(curve);
  EXPECT_EQ(refusal_of([&] {
              untangle(curve, Box_domain_3<>({-1, -1, -1}, {0.9, 1, 1}));
            }),
            "node 0 is not inside the domain");
  EXPECT_EQ(refusal_of([&] {
              untangle(curve, Box_domain_3<>({-1, -1, -2}, {2, 1, 2}),
                       parameters::strategy(Untangling_strategy::SEARCH));
            }),
            "strategy is search, but must be flow or auto in a domain");
  EXPECT_THROW(untangle(curve, meshes::Mesh()), std::invalid_argument);
  EXPECT_EQ(contents(curve), before);
}

// A domain that says that it is unbounded.
struct Unbounded : Box_domain_3<>
{
  Unbounded() : Box_domain_3<>({-9, -9, -9}, {9, 9, 9}) {}

  CGAL::Bbox_3 bbox() const
  {
    const double infinity = std::numeric_limits<double>::infinity();
    return {-infinity, -infinity, -9, infinity, infinity, infinity};
  }
};

TEST(Untangle_in_domain, refuses_unbounded_domains)
{
  Network curve = braid("1 1 1", 60);
  EXPECT_EQ(refusal_of([&] { untangle(curve, Unbounded()); }), "the domain is unbounded");
}

} // namespace test_untangle_in_domain
