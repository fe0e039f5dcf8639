// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_POLYGON_WALK_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_POLYGON_WALK_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/polygon_search/Elementary_operation.h>
#include <CGAL/Volume_filling_curves/internal/polygon_search/Polygon_guard.h>
#include <CGAL/Volume_filling_curves/internal/polygon_search/Search_parameters.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Random walk among the polygons of a knot type: certified random changes of single nodes. Shorter
// curves are always accepted, longer ones sometimes (Metropolis et al. 1953); nodes are inserted
// occasionally and removed wherever possible. The polygon stays coarse, hence moves are long and
// untie knots that a flow cannot. About half a microsecond per move for a hundred edges.
class Polygon_walk
{
  using Index = Search_polygon::Index;

public:
  using Operations = std::vector<Elementary_operation>;

  // Starts from a polygon without its removable nodes.
  Polygon_walk(const Search_polygon& start, const Search_parameters& parameters, std::uint64_t seed)
      : m_parameters(parameters), m_random(seed), m_polygon(start)
  {
    measure();
    reduce();
  }

  const Search_polygon& polygon() const { return m_polygon; }

  // the operations applied to the start
  const Operations& operations() const { return m_operations; }

  // Tries a random change.
  void try_move()
  {
    const Index v = m_polygon.free_node(m_random.index(m_polygon.number_of_free_nodes()));
    double choice = m_random.real();
    if((choice -= m_parameters.removal_rate) < 0)
      remove(v);
    else if((choice -= m_parameters.insertion_rate) < 0)
      insert(m_polygon.edge(v, m_random.index(2)));
    else if((choice -= m_parameters.smoothing_rate) < 0)
      smooth(v);
    else
      shake(v);
  }

  // Adapts steps and clearance to the length of the edges.
  void measure()
  {
    m_mean_length = length() / static_cast<double>(m_polygon.number_of_edges());
    m_clearance = Search_clearance(m_parameters.clearance * m_mean_length);
  }

  // to be done now and then, since edges change their places
  void renumber() { m_polygon.renumber(); }

  // Returns to the polygon that the walk reached by its first `number_of_operations` operations.
  void return_to(const Search_polygon& polygon, std::size_t number_of_operations)
  {
    m_polygon = polygon;
    m_operations.resize(number_of_operations);
  }

private:
  double length() const
  {
    double sum = 0;
    m_polygon.for_each_edge([&](Index e) {
      sum += (position(m_polygon.source(e)) - position(m_polygon.target(e))).norm();
    });
    return sum;
  }

  // Removes all nodes that can be removed, in random order.
  void reduce()
  {
    std::vector<Index> order;
    for(bool has_changed = true; has_changed;) {
      has_changed = false;
      order.clear();
      for(std::size_t k = 0; k < m_polygon.number_of_free_nodes(); ++k)
        order.push_back(m_polygon.free_node(k));
      for(std::size_t k = order.size(); k > 1; --k)
        std::swap(order[k - 1], order[m_random.index(k)]);
      for(Index v : order) has_changed = remove(v) || has_changed;
    }
    m_polygon.renumber();
  }

  bool remove(Index v)
  {
    const Index name = m_polygon.name(v);
    if(!guard().remove_node(v)) return false;
    m_operations.push_back({Elementary_operation::REMOVE, name, 0, Vector()});
    return true;
  }

  void insert(Index e)
  {
    const Index s = m_polygon.source(e), t = m_polygon.target(e);
    const Vector &a = position(s), &c = position(t);
    const Vector b = displaced((a + c) / 2);
    if(!is_acceptable((b - a).norm() + (b - c).norm() - (a - c).norm())) return;
    const Index first = m_polygon.name(s), second = m_polygon.name(t);
    if(guard().insert_node(e, b))
      m_operations.push_back({Elementary_operation::INSERT, first, second, b});
  }

  // towards the middle of the neighbors
  void smooth(Index v)
  {
    const Vector& b = position(v);
    const Vector middle = (neighbor(v, 0) + neighbor(v, 1)) / 2;
    move(v, b + m_random.real() * (middle - b));
  }

  void shake(Index v)
  {
    const Vector &a = neighbor(v, 0), &b = position(v), &c = neighbor(v, 1);
    const Vector target = displaced(b);
    const double increase =
        (target - a).norm() - (b - a).norm() + (target - c).norm() - (b - c).norm();
    if(is_acceptable(increase)) move(v, target);
  }

  void move(Index v, const Vector& target)
  {
    if(guard().move_node(v, target))
      m_operations.push_back({Elementary_operation::MOVE, m_polygon.name(v), 0, target});
  }

  Polygon_guard guard() { return {m_polygon, m_clearance}; }

  const Vector& position(Index v) const { return m_polygon.position(v); }

  const Vector& neighbor(Index v, std::size_t k) const
  {
    return position(m_polygon.neighbor(v, k));
  }

  // Returns a uniform random point of a cube around x, whose size is drawn from several scales.
  Vector displaced(const Vector& x)
  {
    double size = 2 * m_parameters.max_step * m_mean_length;
    for(std::size_t k = m_random.index(m_parameters.number_of_step_sizes); k > 0; --k) size /= 2;
    const double dx = m_random.real(), dy = m_random.real(), dz = m_random.real();
    return x + size * Vector(dx - 0.5, dy - 0.5, dz - 0.5);
  }

  bool is_acceptable(double increase)
  {
    return increase <= 0 ||
           m_random.real() < decay(increase / (m_parameters.temperature * m_mean_length));
  }

  // exp(-x) up to a few per cent, the same on every platform
  static double decay(double x)
  {
    double y = 1 / (1 + x / 256);
    for(int k = 0; k < 8; ++k) y *= y; // y to the power of 256
    return y;
  }

  Search_parameters m_parameters;
  Random_source m_random;
  Search_polygon m_polygon;
  Search_clearance m_clearance;
  Operations m_operations;
  double m_mean_length = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_POLYGON_WALK_H
