// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_surface.h"
#include "support/flow_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/Boundary.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Boundary_limit.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

// Medial spheres inside a domain, in both readings of its boundary, against what they are by
// definition: one direction at a time, over all nodes and the whole boundary, with a single cap.
namespace test_boundary_limit {

using namespace flow_test;
using CGAL::Volume_filling_curves::Ball_domain_3;
using CGAL::Volume_filling_curves::Box_domain_3;
using CGAL::Volume_filling_curves::Triangle_mesh_domain_3;
using CGAL::Volume_filling_curves::Wall;
using exact_surface::Point;
using internal::Medial_spheres;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Domains with the part of a ray from x inside, and the radius of the largest sphere inside that
// touches x and has its center on the ray.

struct Ball
{
  Ball_domain_3<> domain{Point(1, 2, 3), 2};

  Vector from_center(const Vector& x) const { return x - Vector(1, 2, 3); }

  double ray(const Vector& x, const Vector& u) const
  {
    const double along = from_center(x).dot(u);
    return std::sqrt(along * along + 4 - from_center(x).squaredNorm()) - along;
  }

  double sphere(const Vector& x, const Vector& u) const
  {
    return (4 - from_center(x).squaredNorm()) / (2 * (2 + from_center(x).dot(u)));
  }
};

struct Slab
{
  Box_domain_3<> domain{Point(0, 0, 0), Point(4, 4, 0.3)};

  // the least of the distance to a side over how fast it is approached
  template <typename Speed>
  double least(const Vector& x, const Vector& u, const Speed& speed) const
  {
    const Vector high(4, 4, 0.3);
    double result = infinity;
    for(int i = 0; i < 3; ++i) {
      if(speed(u[i]) > 0) result = (std::min)(result, (high[i] - x[i]) / speed(u[i]));
      if(speed(-u[i]) > 0) result = (std::min)(result, x[i] / speed(-u[i]));
    }
    return result;
  }

  double ray(const Vector& x, const Vector& u) const
  {
    return least(x, u, [](double along) { return along; });
  }

  double sphere(const Vector& x, const Vector& u) const
  {
    return least(x, u, [](double along) { return 1 + along; });
  }
};

// A prism whose base has 12 corners, of 44 triangles.
meshes::Soup cylinder()
{
  meshes::Soup soup;
  for(const double z : {0., 3.})
    for(std::size_t k = 0; k < 12; ++k) {
      const double angle = CGAL_PI / 6 * static_cast<double>(k);
      soup.points.emplace_back(0.7 * std::cos(angle), 0.7 * std::sin(angle), z);
    }
  for(std::size_t k = 0; k < 12; ++k) {
    const std::size_t next = (k + 1) % 12;
    soup.faces.push_back({k, next, next + 12});
    soup.faces.push_back({k, next + 12, k + 12});
    if(k == 0 || next == 0) continue;
    soup.faces.push_back({0, next, k});
    soup.faces.push_back({12, k + 12, next + 12});
  }
  return soup;
}

struct Cylinder
{
  Triangle_mesh_domain_3<> domain{meshes::to_mesh(cylinder())};
  exact_surface::Surface surface{cylinder()};

  double ray(const Vector& x, const Vector& u) const
  {
    double result = u.z() > 0 ? (3 - x.z()) / u.z() : u.z() < 0 ? -x.z() / u.z() : infinity;
    const double apothem = 0.7 * std::cos(CGAL_PI / 12);
    for(int k = 0; k < 12; ++k) {
      const double angle = CGAL_PI / 6 * (k + 0.5);
      const Vector normal(std::cos(angle), std::sin(angle), 0);
      if(u.dot(normal) > 0) result = (std::min)(result, (apothem - x.dot(normal)) / u.dot(normal));
    }
    return result;
  }

  // A sphere that touches a point inside lies inside if it holds no point of the surface.
  double sphere(const Vector& x, const Vector& u) const
  {
    double low = 0, high = 10;
    for(int k = 0; k < 40; ++k) {
      const double middle = (low + high) / 2;
      const Vector center = x + middle * u;
      const bool is_free =
          surface.distance({center.x(), center.y(), center.z()}) >= (1 - 1e-12) * middle;
      (is_free ? low : high) = middle;
    }
    return low;
  }
};

// A closed curve with nodes anywhere inside.
template <typename Domain>
Network random_curve(const Domain& domain, std::size_t n, Random& random)
{
  const CGAL::Bbox_3 box = domain.bbox();
  Polygon polygon;
  while(polygon.size() < n) {
    const double x = between(box.xmin(), box.xmax(), random),
                 y = between(box.ymin(), box.ymax(), random),
                 z = between(box.zmin(), box.zmax(), random);
    if(domain.is_inside(Point(x, y, z))) polygon.emplace_back(x, y, z);
  }
  return internal::closed_network({polygon});
}

double radius_between_nodes(const Vector_field& x, const Vector& p, const Vector& u)
{
  double most = 0;
  for(Eigen::Index j = 0; j < x.rows(); ++j) {
    const Vector d = internal::row(x, j) - p;
    if(d.squaredNorm() > 0) most = (std::max)(most, 2 * u.dot(d) / d.squaredNorm());
  }
  return 1 / most; // infinity if no node lies ahead
}

// Takes the radius without walls. Spheres that lie inside are found up to a part of their radius:
// they are not smaller than the largest one, and stick out by less than that part.
template <typename Space>
void expect_radius(
    const Space& space, const Vector& p, const Vector& u, double free, double radius, Wall wall)
{
  if(wall == Wall::COVER) {
    const double expected = (std::min)(free, space.ray(p, u));
    ASSERT_NEAR(radius, expected, 1e-9 * expected);
    return;
  }
  ASSERT_GE(radius, (1 - 1e-9) * (std::min)(free, space.sphere(p, u)));
  ASSERT_LE(radius, (1 + 1e-12) * free);
  const Vector center = p + radius * u;
  ASSERT_GE(space.domain.distance(Point(center.x(), center.y(), center.z())),
            (1 - 3.1e-4) * radius);
}

template <typename Space>
void expect_spheres_as_defined(const Space& space,
                               const Network& curve,
                               const std::vector<double>& thickness,
                               double max_radius,
                               Wall wall)
{
  using Boundary = internal::Boundary<std::decay_t<decltype(space.domain)>>;
  const Boundary walls(space.domain);
  const Vector_field x = internal::coordinates(curve);
  internal::Medial_sphere_search search(CGAL::Sequential_tag(), x, thickness, max_radius,
                                        internal::boundary_limit(curve, walls, wall));
  const Medial_spheres spheres = search(internal::node_circles(curve, x), 16);
  for(std::size_t c = 0; c < spheres.circles().size(); ++c)
    for(std::size_t l = 0; l < 16; ++l) {
      const std::size_t v = spheres.circles()[c].node;
      const Vector p = internal::row(x, v), u = spheres.direction(c, l);
      const double cap = max_radius * thickness[v], of_nodes = radius_between_nodes(x, p, u);
      const double free = (std::min)(cap, of_nodes), radius = spheres.radius(c, l);
      expect_radius(space, p, u, free, radius, wall);
      const auto touched = spheres.touching_node(c, l);
      if(radius < (1 - 1e-9) * free || of_nodes > cap) {
        ASSERT_EQ(touched, Medial_spheres::no_node);
      } else if(of_nodes < (1 - 1e-12) * cap) {
        ASSERT_NE(touched, Medial_spheres::no_node);
        const Vector d = internal::row(x, touched) - p;
        ASSERT_NEAR(2 * u.dot(d) / d.squaredNorm() * of_nodes, 1, 1e-12);
      }
    }
}

template <typename Space>
class Spheres_in : public testing::Test
{};

using Spaces = testing::Types<Ball, Slab, Cylinder>;
struct Name_of_space
{
  template <typename Space>
  static std::string GetName(int)
  {
    return std::is_same_v<Space, Ball> ? "ball" : std::is_same_v<Space, Slab> ? "slab" : "cylinder";
  }
};

TYPED_TEST_SUITE(Spheres_in, Spaces, Name_of_space);

TYPED_TEST(Spheres_in, a_domain_whose_centers_lie_inside)
{
  Random random(1);
  const TypeParam space;
  for(const std::size_t n : {5u, 60u, 600u})
    for(const double max_radius : {0.9, 1.5, 6., 40.}) {
      const Network curve = random_curve(space.domain, n, random);
      expect_spheres_as_defined(space, curve, std::vector<double>(n, 0.1), max_radius, Wall::COVER);
    }
}

TYPED_TEST(Spheres_in, a_domain_that_lie_inside)
{
  Random random(2);
  const TypeParam space;
  for(const std::size_t n : {5u, 40u})
    for(const double max_radius : {1.5, 6.}) {
      const Network curve = random_curve(space.domain, n, random);
      expect_spheres_as_defined(space, curve, std::vector<double>(n, 0.1), max_radius,
                                Wall::KEEP_CLEAR);
    }
}

TYPED_TEST(Spheres_in, a_domain_with_a_thickness_that_varies)
{
  Random random(3);
  const TypeParam space;
  const std::size_t n = 40;
  for(const double max_radius : {1.5, 6.}) {
    const Network curve = random_curve(space.domain, n, random);
    std::vector<double> thickness;
    for(std::size_t v = 0; v < n; ++v) thickness.push_back(std::exp(between(-4, -1, random)));
    expect_spheres_as_defined(space, curve, thickness, max_radius, Wall::COVER);
    expect_spheres_as_defined(space, curve, thickness, max_radius, Wall::KEEP_CLEAR);
  }
}

// The spheres of one node speed up the search for the next, without an effect on the result: the
// bits are the same in separate queries.
TYPED_TEST(Spheres_in, a_domain_do_not_depend_on_what_else_is_sought)
{
  Random random(5);
  const TypeParam space;
  using Boundary = internal::Boundary<std::decay_t<decltype(space.domain)>>;
  const Boundary walls(space.domain);
  for(const std::size_t n : {60u, 600u})
    for(const Wall wall : {Wall::COVER, Wall::KEEP_CLEAR}) {
      const Network curve = random_curve(space.domain, n, random);
      const Vector_field x = internal::coordinates(curve);
      const std::vector<double> thickness(n, 0.2);
      internal::Medial_sphere_search search(CGAL::Sequential_tag(), x, thickness, 6,
                                            internal::boundary_limit(curve, walls, wall));
      const Medial_spheres all = search(internal::node_circles(curve, x), 16);
      for(std::size_t c = 0; c < all.circles().size(); ++c) {
        const Medial_spheres one = search({all.circles()[c]}, 16);
        for(std::size_t l = 0; l < 16; ++l) {
          ASSERT_EQ(one.radius(0, l), all.radius(c, l));
          ASSERT_EQ(one.touching_node(0, l), all.touching_node(c, l));
        }
      }
    }
}

// The caps that are tried one after another do not show.
TEST(Boundary_limit, leaves_the_spheres_alone_where_the_walls_are_far)
{
  Random random(4);
  const Ball_domain_3<> domain(Point(0, 0, 0), 1e4);
  const internal::Boundary<Ball_domain_3<>> walls(domain);
  const Network curve = internal::closed_network({random_polygon(200, random)});
  const Vector_field x = internal::coordinates(curve);
  const std::vector<double> thickness(200, 0.05);
  for(const double max_radius : {0.9, 6., 100.})
    for(const Wall wall : {Wall::COVER, Wall::KEEP_CLEAR}) {
      const Medial_spheres expected = spheres_of(curve, 16, max_radius, 0.05);
      internal::Medial_sphere_search search(CGAL::Sequential_tag(), x, thickness, max_radius,
                                            internal::boundary_limit(curve, walls, wall));
      const Medial_spheres spheres = search(internal::node_circles(curve, x), 16);
      for(std::size_t c = 0; c < spheres.circles().size(); ++c)
        for(std::size_t l = 0; l < 16; ++l) {
          ASSERT_EQ(spheres.radius(c, l), expected.radius(c, l));
          ASSERT_EQ(spheres.touching_node(c, l), expected.touching_node(c, l));
        }
    }
}

} // namespace test_boundary_limit
