// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_surface.h"
#include "support/guard_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

// Every change that the guard accepts keeps a curve inside its domain, and nothing else is refused
// on account of the domain: by brute force on lattices, and recounted exactly along random walks.
namespace test_containment {

using namespace guard_test;
using namespace CGAL::Volume_filling_curves;
using exact_surface::Point;
using exact_surface::Soup;
using exact_surface::Surface;
using Mesh_domain = Triangle_mesh_domain_3<>;
using Network = Curve_network_3<>;
using Free_guard = Isotopy_guard_3<>;
using Guard = Isotopy_guard_3<Curve_flow_traits_3<>, Mesh_domain>;
using Count = std::array<std::size_t, 2>;

// Integers, so that brute force needs no rationals: faces of a mesh, and triangles.
struct Lattice_surface
{
  Lattice_surface(const Soup& soup, Integer scale)
  {
    const auto corner = [&](std::size_t v) {
      const Point& p = soup.points[v];
      return Lattice_point{scale * std::lround(p.x()), scale * std::lround(p.y()),
                           scale * std::lround(p.z())};
    };
    for(const meshes::Face& f : soup.faces)
      faces.push_back({corner(f[0]), corner(f[1]), corner(f[2])});
  }

  bool is_missed(const std::vector<Lattice_point>& triangle) const
  {
    return std::none_of(faces.begin(), faces.end(), [&](const auto& face) {
      return !are_boxes_apart(triangle, face) && brute_force::do_hulls_meet(triangle, face);
    });
  }

  static bool are_boxes_apart(const std::vector<Lattice_point>& a,
                              const std::vector<Lattice_point>& b)
  {
    for(std::size_t i = 0; i < 3; ++i) {
      const auto by_axis = [&](const Lattice_point& p, const Lattice_point& q) {
        return p[i] < q[i];
      };
      const auto [a_low, a_high] = std::minmax_element(a.begin(), a.end(), by_axis);
      const auto [b_low, b_high] = std::minmax_element(b.begin(), b.end(), by_axis);
      if((*a_high)[i] < (*b_low)[i] || (*b_high)[i] < (*a_low)[i]) return true;
    }
    return false;
  }

  bool may_move(const Curve& curve, std::size_t v, const Lattice_point& target) const
  {
    for(const std::size_t e : curve.edges_at(v))
      if(!is_missed({curve.points[v], target, curve.points[curve.opposite(v, e)]})) return false;
    return true;
  }

  bool holds(const Curve& curve) const
  {
    for(std::size_t e = 0; e < curve.edges.size(); ++e)
      if(!is_missed(curve.segment(e))) return false;
    return true;
  }

  std::vector<std::vector<Lattice_point>> faces;
};

// Two legs of width 4 with a wall of width 4 between them.
struct Lattice_domain
{
  Soup soup = exact_surface::scaled(exact_surface::two_legs(1), 4);
  Mesh_domain domain{meshes::to_mesh(soup)};

  // an embedded curve with nodes on the lattice, in the left leg or in the bottom
  Network random_curve(Random& random) const
  {
    const Lattice_surface surface(soup, 1);
    for(;;) {
      Curve curve = random_graph(random);
      for(int attempt = 0; attempt < 20; ++attempt) {
        for(Lattice_point& p : curve.points) p = random_inside(random);
        if(is_embedded(curve) && surface.holds(curve)) return to_network(curve);
      }
    }
  }

  static Lattice_point random_inside(Random& random)
  {
    const auto narrow = [&] { return static_cast<Integer>(1 + below(3, random)); };
    const auto wide = [&] { return static_cast<Integer>(1 + below(11, random)); };
    const Integer x = below(2, random) == 0 ? narrow() : wide();
    const Integer y = x < 4 ? wide() : narrow();
    return {x, y, narrow()};
  }
};

Lattice_point stepped(const Lattice_point& p, Random& random)
{
  const Integer reach = 1 + static_cast<Integer>(below(4, random));
  Lattice_point q = p;
  for(Integer& x : q)
    x += static_cast<Integer>(below(static_cast<std::size_t>(2 * reach + 1), random)) - reach;
  return q;
}

// A random change of one node; `is_missed` returns whether its triangles miss the surface.
template <typename SomeGuard>
bool change(SomeGuard& guard, const Lattice_surface& surface, unsigned seed, bool& is_missed)
{
  Random random(seed);
  const Curve curve = to_curve(guard.curve());
  const std::size_t v = below(curve.points.size(), random), e = below(curve.edges.size(), random);
  const Lattice_point target = stepped(curve.points[v], random);
  const auto [a, c] = curve.edges[e];
  switch(below(3, random)) {
  case 0:
    is_missed = surface.may_move(curve, v, target);
    return guard.move_node(v, to_point(target));
  case 1: {
    const Lattice_point b = stepped(curve.points[a], random);
    is_missed = surface.is_missed({curve.points[a], b, curve.points[c]});
    return guard.insert_node(e, to_point(b));
  }
  default:
    const auto at_v = curve.edges_at(v);
    if(at_v.size() == 2)
      is_missed = surface.is_missed({curve.points[curve.opposite(v, at_v[0])], curve.points[v],
                                     curve.points[curve.opposite(v, at_v[1])]});
    return guard.remove_node(v);
  }
}

TEST(Containment, refuses_what_meets_the_surface_and_nothing_else)
{
  const Lattice_domain place;
  const Lattice_surface surface(place.soup, 1);
  Random random(1);
  int number_of_refused = 0, number_of_accepted = 0;
  for(unsigned repeat = 0; repeat < 3000; ++repeat) {
    const Network before = place.random_curve(random);
    Network free = before, guarded = before;
    Free_guard free_guard(free);
    Guard guard(guarded, place.domain);
    bool is_missed = true;
    const bool is_free = change(free_guard, surface, repeat, is_missed);
    const bool is_expected = is_free && is_missed;
    number_of_accepted += is_expected;
    number_of_refused += is_free && !is_missed;
    ASSERT_EQ(change(guard, surface, repeat, is_missed), is_expected) << repeat;
    ASSERT_EQ(contents(guarded), contents(is_expected ? free : before)) << repeat;
  }
  EXPECT_GT(number_of_accepted, 500);
  EXPECT_GT(number_of_refused, 300);
}

constexpr Integer scale = 64; // makes an eighth of a quarter of the way an integer

// returns in how many rounds the nodes may go the part 1 / `divisor` of the way, 0 if not at all
int rounds_to(const Curve& start,
              const std::vector<Lattice_point>& way,
              Integer divisor,
              const Lattice_surface& surface)
{
  for(const int rounds : {1, 2, 4, 8})
    for(const bool is_reversed : {false, true}) {
      Curve curve = start;
      bool is_safe = true;
      for(Integer k = 1; k <= rounds; ++k)
        for(std::size_t i = 0; i < way.size() && is_safe; ++i) {
          const std::size_t v = is_reversed ? way.size() - 1 - i : i;
          const Lattice_point target = start.points[v] + (k * scale / (rounds * divisor)) * way[v];
          is_safe = may_move(curve, v, target) && surface.may_move(curve, v, target);
          curve.points[v] = target;
        }
      if(is_safe) return rounds;
    }
  return 0;
}

TEST(Containment, decides_steps_of_all_nodes_as_brute_force)
{
  const Lattice_domain place;
  const Lattice_surface surface(place.soup, scale);
  Random random(2);
  std::map<int, int> count;
  for(int repeat = 0; repeat < 500; ++repeat) {
    Network network = place.random_curve(random);
    const Curve unscaled = to_curve(network), start = to_curve(network, scale);
    const Lattice_point zero = {0, 0, 0}, common = stepped(zero, random);
    std::vector<Lattice_point> way;
    Targets targets = internal::coordinates(network);
    for(std::size_t v = 0; v < unscaled.points.size(); ++v) {
      way.push_back(repeat % 2 == 0         ? common
                    : below(2, random) == 0 ? stepped(zero, random)
                                            : zero);
      for(std::size_t i = 0; i < 3; ++i)
        targets(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(i)) +=
            static_cast<double>(way[v][i]);
    }
    Integer divisor = 1;
    int rounds = rounds_to(start, way, divisor, surface);
    while(rounds == 0 && divisor < 4) rounds = rounds_to(start, way, divisor *= 2, surface);
    ++count[rounds == 0 ? 0 : static_cast<int>(divisor)];
    Guard guard(network, place.domain);
    ASSERT_EQ(guard.move_nodes(targets, 0.25), rounds == 0 ? 0 : 1 / static_cast<double>(divisor));
    ASSERT_TRUE(surface.holds(to_curve(network, scale)));
  }
  for(const int divisor : {0, 1, 2, 4}) EXPECT_GT(count[divisor], 20) << divisor;
}

// Certified changes without aim, near the surface and on it where they can.
struct Random_walk
{
  Random_walk(const Soup& soup, unsigned seed)
      : domain(meshes::to_mesh(soup)), guard(network, domain), random(seed)
  {}

  void run(std::size_t number_of_changes)
  {
    const std::size_t end = guard.number_of_certified_changes() + number_of_changes;
    while(guard.number_of_certified_changes() < end) {
      const std::size_t n = network.number_of_nodes(), dice = below(100, random);
      const std::size_t v = below(n, random), e = below(network.number_of_edges(), random);
      if(dice < 2)
        move_all();
      else if(dice < 15 && n > 12)
        guard.remove_node(v);
      else if(dice < 35 && n < 40)
        guard.insert_node(e, near(network.point(network.source(e))));
      else
        guard.move_node(v, near(network.point(v)));
      if(network.has_garbage()) guard.collect_garbage();
    }
  }

  void move_all()
  {
    Targets targets = internal::coordinates(network);
    for(Eigen::Index v = 0; v < targets.rows(); ++v) {
      const Point q = near(network.point(static_cast<std::size_t>(v)));
      if(below(3, random) == 0) targets.row(v) << q.x(), q.y(), q.z();
    }
    guard.move_nodes(targets, 1. / 64);
  }

  Point near(const Point& p)
  {
    const double size = std::ldexp(1, -static_cast<int>(below(8, random)));
    const double x = near(p.x(), size), y = near(p.y(), size);
    return {x, y, near(p.z(), size)};
  }

  // now and then a coordinate that faces have, or one next to it
  double near(double x, double size)
  {
    const double y = x + size * std::uniform_real_distribution<double>(-1, 1)(random);
    switch(below(8, random)) {
    case 0:
      return std::round(y);
    case 1:
      return std::nextafter(std::round(y), x);
    default:
      return y;
    }
  }

  Mesh_domain domain;
  Network network{{{0.25, 0.25, 0.25}, {0.75, 0.25, 0.5}, {0.5, 0.75, 0.75}, {0.25, 0.5, 0.5}},
                  {{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
  Guard guard;
  Random random;
};

TEST(Containment, a_random_walk_stays_inside_coarse_meshes)
{
  const Soup plate = exact_surface::stretched(meshes::cube(), 1, {0, 0.8});
  for(const Soup& soup :
      {meshes::cube(), plate, exact_surface::corner_piece(), exact_surface::two_legs(1e-3)}) {
    const Surface surface(soup);
    Random_walk walk(soup, 3);
    ASSERT_EQ(surface.count_outside(walk.network), Count());
    for(int k = 0; k < 20; ++k) {
      walk.run(100);
      ASSERT_EQ(surface.count_outside(walk.network), Count()) << "after " << 100 * (k + 1);
    }
    EXPECT_GT(walk.guard.number_of_refused_changes(), 500u);
  }
}

// The guard and the domain need not be meshes.
TEST(Containment, a_walk_in_a_ball_stays_inside)
{
  using Ball = Ball_domain_3<>;
  const Ball ball(Point(0, 0, 0), 5); // (3, 4, 0) and the like lie on the sphere
  Network network({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}, {{0, 1}, {1, 2}, {2, 3}});
  Isotopy_guard_3<Curve_flow_traits_3<>, Ball> guard(network, ball);
  EXPECT_FALSE(guard.move_node(0, {3, -4, 0}));
  EXPECT_TRUE(guard.move_node(0, {3, std::nextafter(-4., 0.), 0}));
  Random random(4);
  for(int k = 0; k < 2000; ++k) {
    const std::size_t v = below(network.number_of_nodes(), random);
    guard.move_node(v, to_point(stepped(to_curve(network).points[v], random)));
    const Point& p = network.point(v);
    ASSERT_LT(p.x() * p.x() + p.y() * p.y() + p.z() * p.z(), 25);
  }
}

} // namespace test_containment
