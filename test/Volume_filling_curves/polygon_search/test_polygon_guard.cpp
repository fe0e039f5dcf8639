// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/guard_test_support.h"

#include <CGAL/Volume_filling_curves/internal/polygon_search/Polygon_guard.h>

#include <gtest/gtest.h>

#include <cstddef>

// The guard of the search decides like Isotopy_guard_3, on small lattices full of degenerate cases.
namespace test_polygon_guard {

namespace internal = CGAL::Volume_filling_curves::internal;
using namespace guard_test;
using internal::Search_polygon;
using Network = CGAL::Volume_filling_curves::Curve_network_3<>;
using Index = Search_polygon::Index;

// A network and a polygon that go through the same changes. Nodes of both have the same names.
class Pair_of_guards
{
public:
  explicit Pair_of_guards(const Network& curve)
      : m_network(curve), m_polygon(m_network), m_guard(m_network)
  {}

  // Tries a random change on both, and returns whether both did it.
  bool change(Random& random)
  {
    const Index v = m_polygon.free_node(below(m_polygon.number_of_free_nodes(), random));
    internal::Polygon_guard guard(m_polygon, m_no_clearance);
    const Lattice_point p = random_point(4, false, random);
    const internal::Vector x = internal::to_vector(to_point(p));
    bool by_search = false, by_guard = false;
    switch(below(3, random)) {
    case 0:
      by_guard = internal::to_vector(m_network.point(m_polygon.name(v))) != x &&
                 m_guard.move_node(m_polygon.name(v), to_point(p));
      by_search = guard.move_node(v, x);
      break;
    case 1:
      by_guard = m_guard.remove_node(m_polygon.name(v));
      by_search = guard.remove_node(v);
      break;
    default:
      const Index e = m_polygon.edge(v, below(2, random));
      by_guard = m_guard.insert_node(edge_of_network(e), to_point(p));
      by_search = guard.insert_node(e, x);
    }
    EXPECT_EQ(by_search, by_guard);
    return by_search && by_guard;
  }

  bool is_rigid() const { return m_polygon.number_of_free_nodes() == 0; }

private:
  std::size_t edge_of_network(Index e) const
  {
    const Index s = m_polygon.name(m_polygon.source(e)), t = m_polygon.name(m_polygon.target(e));
    for(std::size_t k = 0; k < m_network.degree(s); ++k)
      if(m_network.neighbor(s, k) == t) return m_network.incident_edge(s, k);
    ADD_FAILURE() << "there is no edge " << s << ", " << t;
    return 0;
  }

  Network m_network;
  Search_polygon m_polygon;
  CGAL::Volume_filling_curves::Isotopy_guard_3<> m_guard;
  internal::Search_clearance m_no_clearance;
};

TEST(Polygon_guard, decides_like_the_guard)
{
  Random random(1);
  std::size_t changes = 0;
  for(int k = 0; k < 1000; ++k) {
    Pair_of_guards guards(to_network(random_curve(4, k % 2 == 0, random)));
    for(int i = 0; i < 50 && !guards.is_rigid() && !HasFailure(); ++i)
      changes += guards.change(random) ? 1 : 0;
  }
  EXPECT_GT(changes, 5000u);
}

TEST(Polygon_guard, keeps_its_clearance)
{
  const Network curve =
      to_network({{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}});
  for(const double distance : {0., 1., 3.}) {
    Search_polygon polygon(curve);
    const internal::Search_clearance clearance(distance);
    internal::Polygon_guard guard(polygon, clearance);
    ASSERT_TRUE(guard.insert_node(0, {4, 2, 0}));
    EXPECT_EQ(guard.move_node(4, {4, 6, 0}), distance < 2.5);
    EXPECT_TRUE(guard.move_node(4, {4, 4, 0}));
  }
}

} // namespace test_polygon_guard
