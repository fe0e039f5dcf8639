// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_NETWORK_3_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_NETWORK_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/Curve_topology.h>
#include <CGAL/Volume_filling_curves/internal/curve/Editor_claim.h>
#include <CGAL/Volume_filling_curves/internal/curve/network_ranges.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/polylines/Polyline_graph.h>
#include <CGAL/Volume_filling_curves/internal/polylines/polyline_ranges.h>
#include <CGAL/Volume_filling_curves/internal/support/check_concepts.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Node_constraint.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Polyline_conventions.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

namespace internal {
template <typename Network>
class Network_editor;
template <typename Network>
class Origin_interpolation;
} // namespace internal

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/Curve_network_3.h
 *
 * \brief The class `Curve_network_3` stores polygonal curves in space: nodes joined by straight
 * edges.
 *
 * Components may be closed or open, junctions (nodes with more than two edges) are allowed, and
 * nodes can be pinned or slide on a set, see `Node_constraint`. Nodes are numbered from 0 along the
 * curve, component after component.
 *
 * Anyone can read a network, but after construction only `Isotopy_guard_3` changes its coordinates
 * and edges, and certifies every change with exact predicates. (Assignment replaces the whole
 * network.) Functions outside this class and the guard require a network without garbage.
 *
 * Construction, copying and renumbering take linear time. Concurrent reading is safe.
 *
 * \tparam Traits_ a model of `CurveFlowTraits_3`, for example \cgal's kernel
 * `CGAL::Exact_predicates_inexact_constructions_kernel`
 */
template <typename Traits_ = Curve_flow_traits_3<>>
class Curve_network_3
{
  static_assert(internal::check_traits<Traits_>());
  static_assert(internal::can_certify<Traits_>(),
                "A kernel that stands for the traits needs exact predicates, and points whose "
                "coordinates can be any double");

  using Topology = internal::Curve_topology;

public:
  /// \name Types and Constants
  /// @{

  /// the traits class
  using Traits = Traits_;

  /// the type of points; their coordinates are of type `double`, or exactly representable by it
  using Point_3 = typename Traits::Point_3;

  /// the type of the indices of nodes, edges and components
  using size_type = std::size_t;

  /// the type of ranges of nodes' indices, a model of `ConstRange` with the value type `size_type`
  using Node_range = internal::Present_range<internal::Is_present_node>;

  /// the type of ranges of edges' indices, a model of `ConstRange` with the value type `size_type`
  using Edge_range = internal::Present_range<internal::Is_present_edge>;

  /// the type of ranges of consecutive indices, a model of `ConstRange` with the value type
  /// `size_type`
  using Index_range = internal::Index_range;

  /// the type of ranges of positions, a model of `ConstRange` with the value type `Point_3`
  using Point_range = internal::Point_range<Point_3>;

  /// returns the index that stands for "no node", for example as the origin of an inserted node.
  static constexpr size_type null_node() { return Topology::null; }

  /// @}

  /// \name Construction
  /// @{

  /// constructs an empty network.
  explicit Curve_network_3(const Traits& traits = Traits()) : m_traits(traits) {}

  /*!
   * constructs a network from points and edges, numbered along the curve.
   *
   * Closed components and paths whose edges have consistent directions keep these; others are
   * assigned one. The i-th point becomes a node `v` with `origin(v) == i`; points without an edge
   * are left out.
   *
   * \param points the nodes' positions, in the input's unit; coordinates are rounded to `double`
   * \param edges pairs of indices of `points`
   * \param traits the traits object
   *
   * \throws std::invalid_argument if an edge has an index out of range, joins a node to itself or
   * occurs twice, or if a coordinate is not a number or beyond 1e150
   * \throws std::length_error if there are \f$2^{32}\f$ or more points or edges
   */
  Curve_network_3(const std::vector<Point_3>& points,
                  const std::vector<std::array<size_type, 2>>& edges,
                  const Traits& traits = Traits())
      : m_traits(traits), m_topology(points.size(), edges)
  {
    m_points.reserve(number_of_nodes());
    for(size_type v = 0; v < number_of_nodes(); ++v) {
      const internal::Vector point = internal::to_vector(points[origin(v)]);
      internal::check_range(point, "point " + std::to_string(origin(v)));
      m_points.push_back(internal::to_point(point, m_traits));
    }
  }

  /*!
   * constructs a network from a polyline, or from a range of polylines.
   *
   * As usual in \cgal, a polyline is closed if its last point repeats the first, see `Closure`.
   * Points are numbered in the order of the range, and `origin()` returns this number; a last point
   * that repeats the first is not numbered. A point that repeats its predecessor is left out. If
   * junctions are allowed, equal end points of polylines are one node; otherwise each polyline is a
   * component, in this order.
   *
   * \tparam PolylineRange a model of `ConstRange` whose items are points, or ranges of points
   * \tparam NamedParameters a sequence of named parameters
   *
   * \param polylines the polylines; coordinates are rounded to `double`
   * \param np an optional sequence of named parameters among the ones listed below
   * \param traits the traits object
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{point_map}
   *     \cgalParamDescription{a property map from the items of the polylines to their points}
   *     \cgalParamType{a model of `ReadablePropertyMap`, and of `WritablePropertyMap` if a result
   *       replaces the polylines, whose key type is the type of the polylines' items and whose
   *       value type has the members `x()`, `y()` and `z()`}
   *     \cgalParamDefault{`CGAL::Identity_property_map<Point_3>()`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{closure}
   *     \cgalParamDescription{which polylines are closed}
   *     \cgalParamType{`Closure`}
   *     \cgalParamDefault{`Closure::IF_REPEATED`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{junctions}
   *     \cgalParamDescription{whether polylines are joined where their ends meet}
   *     \cgalParamType{`Junctions`}
   *     \cgalParamDefault{`Junctions::FORBIDDEN`}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws std::invalid_argument if a polyline has fewer than two distinct points, or fewer than
   * three if it is closed; if a coordinate is not a number or beyond 1e150; or if two polylines are
   * the same edge
   * \throws std::length_error if there are \f$2^{32}\f$ or more points or edges
   */
  template <typename PolylineRange,
            typename NamedParameters = CGAL::parameters::Default_named_parameters,
            typename = std::enable_if_t<internal::is_range_of_items<PolylineRange>>>
  explicit Curve_network_3(const PolylineRange& polylines,
                           const NamedParameters& np = parameters::default_values(),
                           const Traits& traits = Traits())
      : Curve_network_3(internal::graph_of_polylines(polylines, np), traits)
  {}

  /*!
   * constructs a network from matrices, the form that libigl and polyscope use for curves, like the
   * constructor from points and edges.
   *
   * \param points a matrix with one row x, y, z per point
   * \param edges a matrix of an integral type with one row per edge, of two indices of `points`
   * \param traits the traits object
   *
   * \pre `points` has three columns and `edges` two
   *
   * \throws std::invalid_argument like that constructor
   * \throws std::length_error like that constructor
   */
  template <typename Points, typename Edges>
  Curve_network_3(const Eigen::MatrixBase<Points>& points,
                  const Eigen::MatrixBase<Edges>& edges,
                  const Traits& traits = Traits())
      : Curve_network_3(
            internal::rows_to_points(points, traits), internal::rows_to_edges(edges), traits)
  {}

  /// @}

  /// \name Ranges
  /// Ranges skip removed elements.
  /// @{

  /// returns the range of the nodes' indices.
  Node_range nodes() const
  {
    return internal::present_range(internal::Is_present_node{&m_topology}, m_points.size());
  }

  /// returns the range of the indices of the nodes of component `c`, in the order of the curve.
  ///
  /// \pre the network has no garbage
  Index_range nodes(size_type c) const
  {
    CGAL_precondition_msg(!has_garbage(), "the network has no garbage");
    return internal::index_range(first_node(c), first_node(c + 1));
  }

  /// returns the range of the edges' indices.
  Edge_range edges() const
  {
    return internal::present_range(internal::Is_present_edge{&m_topology},
                                   number_of_edges() + number_of_removed_edges());
  }

  /// returns the range of the components' indices.
  Index_range components() const { return internal::index_range(0, number_of_components()); }

  /// returns the range of the nodes' positions.
  Point_range points() const { return internal::point_range<Point_3>(nodes(), m_points); }

  /// returns the bounding box of all nodes, which is empty if there are none.
  Bbox_3 bbox() const
  {
    Bbox_3 box;
    for(const Point_3& point : points()) {
      const internal::Vector p = internal::to_vector(point);
      box += Bbox_3(p.x(), p.y(), p.z(), p.x(), p.y(), p.z());
    }
    return box;
  }

  /// @}

  /// \name Nodes
  /// @{

  /// returns the number of nodes, without removed ones. If the network has no garbage, the nodes
  /// have the indices from 0 up to this number, exclusive; otherwise use `nodes()`.
  size_type number_of_nodes() const { return m_topology.number_of_nodes(); }

  /// returns the number of removed nodes that still have an index. All indices are less than
  /// `number_of_nodes() + number_of_removed_nodes()`.
  size_type number_of_removed_nodes() const { return m_topology.number_of_removed_nodes(); }

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
  /// `curve_origins()` assigns every node a point of the input.
  size_type origin(size_type v) const { return m_topology.origin(v); }

  /// returns the set in which a flow may move node `v`.
  const Node_constraint& constraint(size_type v) const { return m_topology.constraint(v); }

  /// sets the set in which a flow may move node `v`; takes time linear in the number of different
  /// constraints.
  void set_constraint(size_type v, const Node_constraint& constraint)
  {
    m_topology.set_constraint(v, constraint);
  }

  /// returns whether node `v` is free, neither pinned nor sliding.
  bool is_free(size_type v) const { return m_topology.is_free(v); }

  /// returns whether node `v` is pinned, that is, whether its constraint is
  /// `Node_constraint::fixed()`.
  bool is_pinned(size_type v) const { return m_topology.is_fixed(v); }

  /// pins node `v`, or frees it.
  void set_pinned(size_type v, bool is_pinned = true) { m_topology.set_fixed(v, is_pinned); }

  /// returns whether node `v` may be removed: it has two edges, and is free or has the constraint
  /// that a node inserted in its place would have, see `Node_constraint`.
  bool is_removable(size_type v) const { return m_topology.is_removable(v); }

  /// pins all nodes with one edge.
  void pin_ends()
  {
    for(const size_type v : nodes())
      if(degree(v) == 1) set_pinned(v);
  }

  /// @}

  /// \name Edges
  /// @{

  /// returns the number of edges, without removed ones.
  size_type number_of_edges() const { return m_topology.number_of_edges(); }

  /// returns the number of removed edges that still have an index.
  size_type number_of_removed_edges() const { return m_topology.number_of_removed_edges(); }

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

  /// returns the first node of component `c`; the nodes of `c` have the indices from
  /// `first_node(c)` up to `first_node(c + 1)`, exclusive.
  /// \pre the network has no garbage
  size_type first_node(size_type c) const { return m_topology.first_node(c); }

  /// returns whether component `c` is a closed curve without ends and junctions.
  bool is_closed(size_type c) const { return m_topology.is_closed(c); }

  /// returns whether any node has more than two edges.
  bool has_junction() const { return m_topology.has_junction(); }

  /// @}

  /// \name Numbering and Traits
  /// @{

  /// returns whether nodes were inserted or removed since the last numbering.
  bool has_garbage() const { return m_topology.has_garbage(); }

  /// returns the traits object.
  const Traits& traits() const { return m_traits; }

  /// @}

private:
  friend class internal::Network_editor<Curve_network_3>;       // of the guard
  friend class internal::Origin_interpolation<Curve_network_3>; // which reads

  Curve_network_3(const internal::Polyline_graph& graph, const Traits& traits)
      : Curve_network_3(internal::to_points(graph.points(), traits), graph.edges(), traits)
  {}

  Traits m_traits;
  Topology m_topology;
  std::vector<Point_3> m_points;
  internal::Editor_claim m_editor_claim;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_NETWORK_3_H
