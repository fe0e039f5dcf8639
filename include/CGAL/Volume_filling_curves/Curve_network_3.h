// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_CURVE_NETWORK_3_H
#define CGAL_VOLUME_FILLING_CURVES_CURVE_NETWORK_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/Curve_topology.h>
#include <CGAL/Volume_filling_curves/internal/Vector.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Motion_record.h>

#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

template <typename Traits, typename Domain>
class Isotopy_guard_3;

namespace internal {
template <typename Network>
class Tails;
} // namespace internal

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief The class `Curve_network_3` stores polygonal curves in space: nodes joined by straight
 * edges.
 *
 * Components may be closed or open, junctions (nodes with more than two edges) are allowed, and
 * nodes can be pinned. Nodes are numbered from 0 along the curve, component after component.
 *
 * The network can be read by everybody, but once constructed its coordinates and its edges change
 * only through `Isotopy_guard_3`, which certifies every change with exact predicates. (Assigning
 * replaces the network by another one.) Functions that read a network, but for its own and those of
 * the guard, expect that it has no garbage.
 *
 * Constructing, copying and renumbering take time linear in the number of nodes. Concurrent reading
 * is safe.
 *
 * \tparam Traits_ a model of `CurveFlowTraits_3`
 */
template <typename Traits_ = Curve_flow_traits_3<>>
class Curve_network_3
{
  using Topology = internal::Curve_topology;

public:
  /// \name Types
  /// @{

  /// the traits class
  using Traits = Traits_;

  /// the type of points; their coordinates are of type `double`, or exactly representable by it
  using Point_3 = typename Traits::Point_3;

  /// the type of the indices of nodes, edges and components
  using size_type = std::size_t;

  /// @}

  /// stands for "no node", for example as the origin of a node that was inserted.
  static constexpr size_type null_node() { return Topology::null; }

  /// \name Construction
  /// @{

  /// constructs an empty network.
  explicit Curve_network_3(const Traits& traits = Traits()) : m_traits(traits) {}

  /*!
   * constructs a network from points and edges, numbered along the curve.
   *
   * Closed components and paths whose edges follow one another keep that direction; others are
   * given one. The i-th point becomes a node `v` with `origin(v) == i`; points without an edge are
   * left out.
   *
   * \param points the nodes' positions, in the input's unit; coordinates are rounded to `double`
   * \param edges pairs of indices of `points`
   * \param traits the traits object
   *
   * \throws std::invalid_argument if an edge has an index that is out of range, joins a node with
   * itself or occurs twice, or if a coordinate is infinite or not a number
   * \throws std::length_error if there are \f$2^{32}\f$ points or edges, or more
   */
  Curve_network_3(const std::vector<Point_3>& points,
                  const std::vector<std::array<size_type, 2>>& edges,
                  const Traits& traits = Traits())
      : m_traits(traits), m_topology(points.size(), edges)
  {
    m_points.reserve(number_of_nodes());
    for(size_type v = 0; v < number_of_nodes(); ++v) {
      const internal::Vector point = internal::to_vector(points[origin(v)]);
      if(!point.allFinite())
        throw std::invalid_argument("point " + std::to_string(origin(v)) + " is not finite");
      m_points.push_back(internal::to_point(point, m_traits));
    }
  }

  /// @}

  /// \name Nodes
  /// @{

  /// returns the number of nodes, removed ones included as long as there is garbage.
  size_type number_of_nodes() const { return m_topology.number_of_nodes(); }

  /// returns whether node `v` was removed and awaits `Isotopy_guard_3::collect_garbage()`.
  bool is_removed_node(size_type v) const { return m_topology.is_removed_node(v); }

  /// returns the position of node `v`.
  const Point_3& point(size_type v) const { return m_points[v]; }

  /// returns the number of edges at node `v`: 2 inside a curve, 1 at an end, more at a junction.
  size_type degree(size_type v) const { return m_topology.degree(v); }

  /// returns the `k`-th edge at node `v`, with `k < degree(v)`.
  size_type incident_edge(size_type v, size_type k) const { return m_topology.incident_edge(v, k); }

  /// returns the `k`-th neighbor of node `v`, with `k < degree(v)`.
  size_type neighbor(size_type v, size_type k) const
  {
    return m_topology.opposite(v, incident_edge(v, k));
  }

  /// returns the index that node `v` had in the input, or `null_node()` if it was inserted later.
  size_type origin(size_type v) const { return m_topology.origin(v); }

  /// returns whether node `v` is pinned, that is, whether the flow leaves it where it is.
  bool is_pinned(size_type v) const { return m_topology.is_pinned(v); }

  /// pins node `v`, or frees it.
  void set_pinned(size_type v, bool is_pinned = true) { m_topology.set_pinned(v, is_pinned); }

  /// pins all nodes with one edge.
  void pin_ends()
  {
    for(size_type v = 0; v < number_of_nodes(); ++v)
      if(degree(v) == 1) set_pinned(v);
  }

  /// @}

  /// \name Edges
  /// @{

  /// returns the number of edges, removed ones included as long as there is garbage.
  size_type number_of_edges() const { return m_topology.number_of_edges(); }

  /// returns whether edge `e` was removed and awaits `Isotopy_guard_3::collect_garbage()`.
  bool is_removed_edge(size_type e) const { return m_topology.is_removed_edge(e); }

  /// returns the first node of edge `e`.
  size_type source(size_type e) const { return m_topology.source(e); }

  /// returns the second node of edge `e`.
  size_type target(size_type e) const { return m_topology.target(e); }

  /// @}

  /// \name Components
  /// @{

  /// returns the number of connected components. It never changes.
  size_type number_of_components() const { return m_topology.number_of_components(); }

  /// returns the component of node `v`. Components are numbered in the order of the input.
  size_type component(size_type v) const { return m_topology.component(v); }

  /// returns the first node of component `c`; the nodes of `c` are those from `first_node(c)` on,
  /// up to but without `first_node(c + 1)`.
  size_type first_node(size_type c) const { return m_topology.first_node(c); }

  /// returns whether component `c` is a closed curve without ends and junctions.
  bool is_closed(size_type c) const { return m_topology.is_closed(c); }

  /// returns whether some node has more than two edges.
  bool has_junction() const { return m_topology.has_junction(); }

  /// @}

  /// returns whether nodes were inserted or removed since the nodes were numbered.
  bool has_garbage() const { return m_topology.has_garbage(); }

  /// returns the traits object.
  const Traits& traits() const { return m_traits; }

private:
  template <typename, typename>
  friend class Isotopy_guard_3;
  friend class internal::Tails<Curve_network_3>;

  Traits m_traits;
  Topology m_topology;
  std::vector<Point_3> m_points;
  size_type m_revision = 0; // counts the changes, so that a guard notices those of another one
  std::optional<internal::Motion_record> m_record; // of the changes, if they are recorded
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_CURVE_NETWORK_3_H
