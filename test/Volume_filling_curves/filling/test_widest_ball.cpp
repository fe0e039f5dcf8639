// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_surface.h"
#include "support/refusal_of.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/internal/domain/Domain_samples_3.h>
#include <CGAL/Volume_filling_curves/internal/filling/Boundary_distances.h>
#include <CGAL/Volume_filling_curves/internal/filling/Widest_ball.h>

#include <gtest/gtest.h>

#include <array>

// Where a curve starts to grow: where the domain is widest.
namespace test_widest_ball {

using namespace CGAL::Volume_filling_curves;
using exact_surface::Point;
using internal::Vector;
using Traits = Curve_flow_traits_3<>;
using Network = Curve_network_3<>;
using Mesh_domain = Triangle_mesh_domain_3<>;

template <typename Domain>
internal::Widest_ball<Domain, Traits> widest_ball(const Domain& domain, std::size_t n)
{
  static const Traits traits;
  const Domain_samples_3<Traits, Domain> samples(domain, n, 1);
  const internal::Boundary_distances<Domain> distances(domain, samples.points());
  return {domain, samples.points(), distances.up_to_limit(), distances.limit(), traits};
}

TEST(Widest_ball, of_a_ball_is_its_center)
{
  for(const double radius : {1e-30, 2., 1e30}) {
    const Ball_domain_3<> ball(Point(radius, -radius, 0), radius);
    for(const std::size_t n : {1u, 100u}) {
      const auto widest = widest_ball(ball, n);
      EXPECT_GT(widest.radius(), 0.98 * radius);
      EXPECT_LE(widest.radius(), radius);
      EXPECT_LT((widest.center() - radius * Vector(1, -1, 0)).norm(), 0.02 * radius);
    }
  }
}

TEST(Widest_ball, of_a_slab_is_in_its_middle)
{
  const Box_domain_3<> slab(Point(0, 0, 0), Point(10, 10, 0.5));
  const auto widest = widest_ball(slab, 1000);
  EXPECT_GT(widest.radius(), 0.98 * 0.25);
  EXPECT_LE(widest.radius(), 0.25);
}

TEST(Widest_ball, of_a_mesh_is_found_past_its_thin_parts)
{
  meshes::Soup soup = exact_surface::two_legs(1);
  soup = exact_surface::stretched(soup, 0, {0, 1, 1.5, 3.5}); // the second leg is wider
  soup = exact_surface::stretched(soup, 2, {0, 3});
  const Mesh_domain domain(meshes::to_mesh(soup));
  const auto widest = widest_ball(domain, 500);
  EXPECT_GT(widest.center().x(), 1.5);
  EXPECT_GT(widest.radius(), 0.98);
  const Point center(widest.center().x(), widest.center().y(), widest.center().z());
  EXPECT_NEAR(widest.radius(), exact_surface::Surface(soup).distance(center), 1e-9);
}

TEST(Widest_ball, has_room_for_a_circle)
{
  const exact_surface::Surface surface(exact_surface::corner_piece());
  const Mesh_domain domain(meshes::to_mesh(exact_surface::corner_piece()));
  const auto widest = widest_ball(domain, 500);
  const Network circle(widest.circle(widest.radius(), 24));
  EXPECT_EQ(circle.number_of_components(), 1u);
  EXPECT_TRUE(circle.is_closed(0));
  EXPECT_EQ(surface.count_outside(circle), (std::array<std::size_t, 2>{0, 0}));
  EXPECT_NO_THROW(internal::check_inside(circle, domain));
  for(std::size_t v = 0; v < circle.number_of_nodes(); ++v) {
    const Vector x = internal::to_vector(circle.point(v)) - widest.center();
    EXPECT_NEAR(x.norm(), widest.radius() / 2, 1e-12);
  }
}

TEST(Check_inside, names_the_nodes)
{
  const Mesh_domain domain(meshes::to_mesh(exact_surface::two_legs(1e-3)));
  const auto message = [&](const Point& p, const Point& q) {
    const Network curve({Point(0.5, 0.5, 0.5), p, q}, {{0, 1}, {1, 2}});
    return refusal_of([&] { internal::check_inside(curve, domain); });
  };
  EXPECT_EQ(message({0.5, 1, 0.5}, {0.5, 2, 0.5}), "");
  EXPECT_EQ(message({0.5, 1, 0.5}, {0.5, 3, 0.5}), "node 2 is not inside the domain");
  EXPECT_EQ(message({0.5, 2, 0.5}, {1.5, 2, 0.5}),
            "the edge of nodes 1 and 2 meets the boundary of the domain");
}

} // namespace test_widest_ball
