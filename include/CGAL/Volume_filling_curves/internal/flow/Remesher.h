// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_REMESHER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_REMESHER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/flow/Node_set.h>
#include <CGAL/Volume_filling_curves/internal/geometry/bending.h>
#include <CGAL/Volume_filling_curves/internal/guard/halve_edge.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Remeshing to edge lengths between h and 2h, where h may vary from node to node, by certified
// operations (section 4.4 of the paper). An edge shorter than h loses one of its ends; if that
// would leave an edge longer than 2h, which would be split again, the end moves to the middle of
// its neighbors instead. Edges longer than 2h are split in the middle. Refused operations leave
// their edges unchanged. The guard's watch can end the remeshing. Linear time; edges are measured
// in parallel with a parallel tag.
template <typename Guard, typename ConcurrencyTag = Sequential_tag>
class Remesher
{
  using Network = typename Guard::Curve_network;
  using Traits = typename Network::Traits;

public:
  // Takes h for each node; an edge has the mean of its ends.
  Remesher(Guard& guard, std::vector<double> spacing)
      : m_guard(guard), m_curve(guard.curve()), m_spacing(std::move(spacing))
  {}

  // Leaves garbage in the network if it changes anything but positions.
  void collapse_short_edges()
  {
    const auto is_short = [this](std::size_t e) { return length(e) < spacing(e); };
    find_due_edges(is_short);
    for(std::size_t e = 0; e < m_is_due.size(); ++e) {
      if(!m_is_due[e] || m_curve.is_removed_edge(e) || !is_short(e)) continue;
      if(must_stop()) return;
      check_run();
      collapse(e);
    }
  }

  void split_long_edges()
  {
    find_due_edges([this](std::size_t e) { return length(e) > 2 * spacing(e); });
    for(std::size_t e = 0; e < m_is_due.size(); ++e) {
      if(!m_is_due[e]) continue;
      if(must_stop()) return;
      check_run();
      split(e);
    }
  }

  // Removes nodes at which the curve turns back and its bend radius is below the node's least one.
  // Leaves garbage in the network.
  void remove_folds(const std::vector<double>& min_radii)
  {
    const std::size_t n = m_curve.number_of_nodes() + m_curve.number_of_removed_nodes();
    for(std::size_t v = 0; v < n; ++v) {
      if(m_curve.is_removed_node(v) || !is_fold(v, min_radii[v])) continue;
      if(must_stop()) return;
      check_run();
      m_guard.remove_node(v);
    }
  }

  std::size_t number_of_refusals() const { return m_number_of_refusals; }

private:
  bool must_stop() const { return m_guard.watch() != nullptr && m_guard.watch()->must_stop(); }

  // Looks for the edges for which a predicate holds.
  template <typename Predicate>
  void find_due_edges(const Predicate& is_due)
  {
    m_is_due.assign(m_curve.number_of_edges() + m_curve.number_of_removed_edges(), false);
    for_each_index<ConcurrencyTag>(m_is_due.size(), [&](std::size_t e) {
      m_is_due[e] = !m_curve.is_removed_edge(e) && is_due(e);
    });
  }

  Vector position(std::size_t v) const { return to_vector(m_curve.point(v)); }

  double length(std::size_t e) const { return edge_vector(m_curve, e).norm(); }

  double spacing(std::size_t e) const
  {
    return (m_spacing[m_curve.source(e)] + m_spacing[m_curve.target(e)]) / 2;
  }

  bool is_fold(std::size_t v, double min_radius) const
  {
    if(!m_curve.is_removable(v)) return false;
    const Vector in = position(v) - position(m_curve.neighbor(v, 0));
    const Vector out = position(m_curve.neighbor(v, 1)) - position(v);
    return in.dot(out) < 0 && bend_radius(in, out) < min_radius;
  }

  // the length of the edge that would replace node v
  double length_without(std::size_t v) const
  {
    return (position(m_curve.neighbor(v, 0)) - position(m_curve.neighbor(v, 1))).norm();
  }

  void collapse(std::size_t e)
  {
    std::size_t first = m_curve.source(e), second = m_curve.target(e);
    for(const std::size_t v : {first, second}) // these edges change, or are joined
      for(std::size_t k = 0; k < m_curve.degree(v); ++k)
        m_is_due[m_curve.incident_edge(v, k)] = true;
    if(!m_curve.is_removable(first)) std::swap(first, second);
    if(!m_curve.is_removable(first)) return;
    if(m_curve.is_removable(second) && length_without(second) < length_without(first))
      std::swap(first, second);
    if(length_without(first) > 2 * m_spacing[first])
      count(m_guard.move_node(first, middle(first)));
    else if(!m_guard.remove_node(first))
      count(m_curve.is_removable(second) && length_without(second) <= 2 * m_spacing[second] &&
            m_guard.remove_node(second));
  }

  void split(std::size_t e)
  {
    const double h = spacing(e);
    const bool is_done = halve_edge(m_guard, e);
    if(is_done) m_spacing.push_back(h);
    count(is_done);
    if(is_done && !m_curve.is_free(m_curve.target(e)))
      m_guard.move_node(m_curve.target(e), middle(m_curve.target(e)));
  }

  // of the neighbors, or the point nearest to it in the set in which the node moves
  typename Traits::Point_3 middle(std::size_t v) const
  {
    const Vector target = (position(m_curve.neighbor(v, 0)) + position(m_curve.neighbor(v, 1))) / 2;
    return to_point(Node_set(m_curve, m_guard.boundary(), v).nearest(target), m_curve.traits());
  }

  void count(bool is_done) { m_number_of_refusals += is_done ? 0 : 1; }

  Guard& m_guard;
  const Network& m_curve;
  std::vector<double> m_spacing; // per node
  std::vector<char> m_is_due;    // per edge: whether it may have to be changed
  std::size_t m_number_of_refusals = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_REMESHER_H
