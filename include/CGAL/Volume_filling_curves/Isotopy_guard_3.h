// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_ISOTOPY_GUARD_3_H
#define CGAL_VOLUME_FILLING_CURVES_ISOTOPY_GUARD_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_observer_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/Network_editor.h>
#include <CGAL/Volume_filling_curves/internal/domain/Boundary.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/guard/Certified_motion.h>
#include <CGAL/Volume_filling_curves/internal/guard/Local_change_certifier.h>
#include <CGAL/Volume_filling_curves/internal/guard/Motion_limits.h>
#include <CGAL/Volume_filling_curves/internal/guard/Motion_record.h>
#include <CGAL/Volume_filling_curves/internal/guard/Shortened_motion.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/support/check_concepts.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Bend_limits.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Unbounded_domain_3.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief The class `Isotopy_guard_3` is the only way to change a `Curve_network_3`: it makes a
 * change only if it can certify it.
 *
 * Exact predicates certify that a change is an ambient isotopy: the curve never passes through
 * itself. All changes consist of the elementary moves of knot theory \cgalCite{vfc:r-ebt-26}: an
 * edge is replaced by two sides of a triangle that meets the rest of the curve only in the ends of
 * the edge, or the reverse. Degenerate positions are decided exactly. For open curves the
 * certificate proves that no strand passes through another; a strand may slip off an end.
 *
 * On request the guard also keeps a clearance, since curves in contact can hardly move again. It
 * refuses a change that brings two edges without a common node closer than a given distance and
 * also closer than half their former distance. It refuses a change that narrows the angle between
 * edges with a common node below 20 degrees and also below about half its former value. Hence
 * repeated changes can wear a clearance down, but not `Bend_limits`. The clearance is not part of
 * the certificate.
 *
 * Inserting and removing nodes leaves gaps in the numbering, which `collect_garbage()` closes.
 * Positions are rounded to `double` before they are certified; positions that are not finite, or
 * have coordinates beyond 1e150, are refused.
 *
 * If edges have similar lengths, a change of one node takes constant time, and a motion of all
 * nodes near-linear time.
 *
 * The guard borrows the network, which must outlive it and must not be assigned to meanwhile. A
 * network has at most one guard. Algorithms that change the network, such as `Curve_flow_3`, take
 * the guard; `untangle()`, `fill()` and `simplify_curves()` construct their own. Guards of
 * different networks can be used concurrently.
 *
 * With a domain, all that the curve sweeps must also lie strictly inside: a curve that starts
 * inside stays inside. This is as reliable as the answers of the domain.
 *
 * Every node has an edge: networks and certificates leave out points without one, and no change
 * removes the last edge of a remaining node.
 *
 * \pre the network is embedded: two of its edges meet at most in a common node
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3` with the same point type, bounded, or
 * `Unbounded_domain_3`
 */
template <typename Traits = Curve_flow_traits_3<>, typename Domain = Unbounded_domain_3<Traits>>
class Isotopy_guard_3
{
  static_assert(internal::check_domain<Domain, typename Curve_network_3<Traits>::Point_3>());

public:
  /// \name Types
  /// @{

  /// the type of the curve
  using Curve_network = Curve_network_3<Traits>;

  /// the type of points
  using Point_3 = typename Traits::Point_3;

  /// the type of the indices of nodes and edges
  using size_type = typename Curve_network::size_type;

  /// the type of observers of changes
  using Observer = Curve_network_observer_3<Traits>;

  /// @}

  /// constructs a guard of `curve` without a domain. `Domain` must be `Unbounded_domain_3`.
  /// \throws std::logic_error if the network has a guard
  explicit Isotopy_guard_3(Curve_network_3<Traits>& curve) : Isotopy_guard_3(curve, Boundary()) {}

  /// constructs a guard that keeps `curve` inside `domain`, which must outlive the guard.
  /// \pre the curve lies inside `domain`
  /// \throws std::invalid_argument if the domain is smaller than 1e-150, if its box is empty, or if
  /// it is unbounded and not `Unbounded_domain_3`
  /// \throws std::logic_error if the network has a guard
  Isotopy_guard_3(Curve_network_3<Traits>& curve, const Domain& domain)
      : Isotopy_guard_3(curve, Boundary(domain))
  {}

  Isotopy_guard_3(const Isotopy_guard_3&) = delete;
  Isotopy_guard_3& operator=(const Isotopy_guard_3&) = delete;

  /// returns the guarded network.
  const Curve_network& curve() const { return m_curve; }

  /// sets the clearance, in the input's unit; 0 (default) or less stands for none. A change brings
  /// edges without a common node nearer than that only if it leaves at least half of their
  /// distance.
  void set_clearance(double distance) { m_clearance = internal::Clearance_rule(distance); }

  /// returns the clearance, 0 if there is none.
  double clearance() const { return m_clearance.distance(); }

  /// sets the distance from the boundary of the domain that the curve keeps, in the input's unit; 0
  /// (default) or less stands for none. Needs a domain. Certified like containment, if the domain's
  /// distances are lower bounds.
  /// \pre the curve is farther than that from the boundary, see `min_wall_distance()`
  void set_wall_distance(double distance) { set_wall_distance(distance, 0); }

  /// sets the bend radius and the distance between strands that changes keep, in addition to the
  /// clearance; none by default. Rays are exempt.
  void set_bend_limits(const Bend_limits<Point_3>& limits) { m_bends = limits; }

  /// returns the bend radius and the distance between strands that changes keep.
  const Bend_limits<Point_3>& bend_limits() const { return m_bends; }

  /// \name Certified Operations
  /// @{

  /// moves node `v` to `target` if that is certified, and returns whether it did. Pinned nodes move
  /// as well: pins only concern the flow.
  /// \pre the node has not been removed
  bool move_node(size_type v, const Point_3& target)
  {
    CGAL_precondition_msg(!m_curve.is_removed_node(v), "the node has not been removed");
    const std::optional<Point_3> p = rounded(target);
    if(p && m_predicates.are_equal(m_curve.point(v), *p)) return change_if(true, [] {});
    return change_if(p && m_certifier.is_move_safe(v, *p, m_clearance, m_bends),
                     [&] { m_editor.move_node(v, *p); });
  }

  /// replaces edge `e` by two edges to a new node at `position` if that is certified, and returns
  /// whether it did. The edge from `source(e)` keeps the index `e`; hence the new node is
  /// `target(e)`, with the largest index.
  /// \pre the edge has not been removed
  bool insert_node(size_type e, const Point_3& position)
  {
    CGAL_precondition_msg(!m_curve.is_removed_edge(e), "the edge has not been removed");
    const std::optional<Point_3> p = rounded(position);
    return change_if(p && m_certifier.is_insertion_safe(e, *p, m_clearance, m_bends),
                     [&] { m_editor.insert_node(e, *p); });
  }

  /// removes node `v` and joins its two neighbors by an edge if that is certified, and returns
  /// whether it did. Ends, junctions and constrained nodes stay (see
  /// `Curve_network_3::is_removable()`), and a closed component keeps 3 edges.
  bool remove_node(size_type v)
  {
    return change_if(m_curve.is_removable(v) && !internal::has_ray(m_curve, v) &&
                         m_certifier.is_removal_safe(v, m_clearance, m_bends),
                     [&] { m_editor.remove_node(v); });
  }

  /*!
   * moves all nodes towards their targets, as far as this is certified.
   *
   * Tries the fractions 1, 1/2, 1/4, ... of the displacements down to `min_fraction`.
   *
   * \tparam ConcurrencyTag enables parallel algorithms: `Sequential_tag` (default), `Parallel_tag`
   * or `Parallel_if_available_tag`; the result is the same
   *
   * \param targets one row per node with its x, y and z
   * \param min_fraction the least fraction to try
   *
   * \returns the fraction of their displacements that the nodes moved, 0 if none was certified
   *
   * \pre the network has no garbage
   * \pre `targets` has one row per node
   * \pre `min_fraction` is positive and at most 1
   */
  template <typename ConcurrencyTag = Sequential_tag>
  double move_nodes(const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>& targets,
                    double min_fraction = 1)
  {
    CGAL_precondition_msg(min_fraction > 0 && min_fraction <= 1,
                          "`min_fraction` is positive and at most 1");
    if(!are_in_range(targets)) return 0;
    const size_type n = m_curve.number_of_nodes();
    const Limits limits(ConcurrencyTag(), m_curve, targets, m_clearance, m_boundary, m_bends);
    const internal::Certified_motion<Limits, ConcurrencyTag> motion(limits, m_watch);
    for(double fraction = 1; fraction >= min_fraction; fraction /= 2) {
      const auto rounds = motion.certify(fraction);
      if(!rounds.positions.empty()) {
        m_editor.move_nodes(rounds);
        m_number_of_certified += n;
        return fraction;
      }
      m_number_of_refused += n;
    }
    return 0;
  }

  /*!
   * moves each node towards its target as far as nearby nodes allow: nodes that block one another,
   * or meet a boundary, move 1/2, 1/4, ..., 1/64 of their displacements, or stay; all others move
   * fully.
   *
   * \tparam ConcurrencyTag enables parallel algorithms: `Sequential_tag` (default), `Parallel_tag`
   * or `Parallel_if_available_tag`; the result is the same
   *
   * \param targets one row per node with its x, y and z
   *
   * \returns the fraction of its displacement that each node moved
   *
   * \pre the network has no garbage
   * \pre `targets` has one row per node
   */
  template <typename ConcurrencyTag = Sequential_tag>
  std::vector<double> advance_nodes(
      const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>& targets)
  {
    const size_type n = m_curve.number_of_nodes();
    if(!are_in_range(targets)) return std::vector<double>(n, 0);
    const Limits limits(ConcurrencyTag(), m_curve, targets, m_clearance, m_boundary, m_bends);
    internal::Shortened_motion<Limits, ConcurrencyTag> motion(limits, m_watch);
    m_editor.move_nodes(motion());
    const auto held =
        static_cast<size_type>(std::count(motion.fractions().begin(), motion.fractions().end(), 0));
    m_number_of_certified += n - held;
    m_number_of_refused += held;
    return motion.fractions();
  }

  /// adds a ray from `v`, a node with one edge, to a new last node at `tip` if the ray is certified
  /// to meet the curve only in `v`, and returns whether it did. A strand can then slip off this end
  /// only around the tip, which should lie beyond all that the curve reaches. Rays and their nodes
  /// have no origin; the tip is pinned. Remove all rays before you call `start_recording()` or
  /// `certificate()`.
  /// \pre the node has not been removed
  bool add_ray(size_type v, const Point_3& tip)
  {
    CGAL_precondition_msg(!m_curve.is_removed_node(v), "the node has not been removed");
    const std::optional<Point_3> p = rounded(tip);
    return change_if(p && m_certifier.is_ray_safe(v, *p, m_clearance),
                     [&] { m_editor.append_leaf(v, *p); });
  }

  /// removes all rays, and closes the gaps in the numbering.
  void remove_rays() { internal::remove_rays(m_curve, m_editor); }

  /// @}

  /// pins or frees node `v`, like `Curve_network_3::set_pinned()`.
  void set_pinned(size_type v, bool is_pinned = true) { m_editor.set_pinned(v, is_pinned); }

  /// sets the set in which node `v` may move, like `Curve_network_3::set_constraint()`.
  void set_constraint(size_type v, const Node_constraint& constraint)
  {
    m_editor.set_constraint(v, constraint);
  }

  /// closes the gaps of removed nodes, renumbers the nodes along the curve, and returns the former
  /// index of each node.
  std::vector<std::uint32_t> collect_garbage() { return m_editor.collect_garbage(); }

  /// \name Observers and Certificate
  /// @{

  /// adds an observer of every change of points or edges. It must outlive the guard or be removed
  /// before.
  void add_observer(Observer& observer) { m_editor.add(observer); }

  /// removes an observer, or does nothing if it was not added. Observers must not be added or
  /// removed while they are called.
  void remove_observer(Observer& observer) { m_editor.remove(observer); }

  /// starts recording changes, and discards any former record.
  /// \pre the network has no garbage, and there are no rays
  void start_recording()
  {
    CGAL_precondition_msg(!m_curve.has_garbage(), "the network has no garbage");
    stop_recording();
    m_record = std::make_unique<internal::Motion_record<Curve_network>>(m_curve);
    m_editor.add(*m_record);
  }

  /// stops recording changes, and discards the record.
  void stop_recording()
  {
    if(m_record) m_editor.remove(*m_record);
    m_record.reset();
  }

  /// returns whether changes are recorded.
  bool is_recording() const { return m_record != nullptr; }

  /// returns the certificate of the motion from the start of the recording to the current network.
  /// The recording continues. Takes time linear in the length of the record.
  /// \pre changes are recorded, and there are no rays
  Isotopy_certificate certificate() const
  {
    CGAL_precondition_msg(is_recording(), "changes are recorded");
    return Isotopy_certificate::of_bytes(m_record->certificate());
  }

  /// @}

  /// \name Statistics
  /// @{

  /// returns the number of changes of a node that were certified and made. A motion of all nodes
  /// counts each.
  size_type number_of_certified_changes() const { return m_number_of_certified; }

  /// returns the number of changes of a node that were refused. Each fraction that `move_nodes()`
  /// tries in vain counts each node.
  size_type number_of_refused_changes() const { return m_number_of_refused; }

  /// @}

  /// \cond SKIP_IN_MANUAL
  using Boundary = internal::Boundary<Domain>;
  const Boundary& boundary() const { return m_boundary; }

  // likewise; the flow takes a layer along the boundary for outside, see `Boundary`
  void set_wall_distance(double distance, double layer)
  {
    m_boundary.set_wall_distance(distance, layer);
  }

  // Sets the watch, or none if it is null. Motions of all nodes throw Run_stopped before they move
  // any; users of the guard, such as the remesher, stop between two certified changes.
  void set_watch(internal::Run_watch* watch) { m_watch = watch; }
  internal::Run_watch* watch() const { return m_watch; }

  auto counts() { return std::tie(m_number_of_certified, m_number_of_refused); }
  internal::Motion_record<Curve_network>* record() { return m_record.get(); } // or null
  /// \endcond

private:
  Isotopy_guard_3(Curve_network& curve, Boundary&& boundary)
      : m_curve(curve), m_editor(curve), m_boundary(std::move(boundary))
  {
    m_editor.add(m_locator);
  }

  using Limits = internal::Motion_limits<Curve_network, Boundary>;

  template <typename Change>
  bool change_if(bool is_certified, const Change& change)
  {
    ++(is_certified ? m_number_of_certified : m_number_of_refused);
    if(is_certified) change();
    return is_certified;
  }

  // Returns whether all targets are in range. If one is not, all nodes count as refused.
  bool are_in_range(const internal::Vector_field& targets)
  {
    CGAL_precondition_msg(!m_curve.has_garbage(), "the network has no garbage");
    CGAL_precondition_msg(static_cast<size_type>(targets.rows()) == m_curve.number_of_nodes(),
                          "`targets` has one row per node");
    const bool are_accepted = (targets.array().abs() <= internal::max_coordinate).all();
    if(!are_accepted) m_number_of_refused += m_curve.number_of_nodes();
    return are_accepted;
  }

  // Returns the position as it is stored, or none if it is out of range.
  std::optional<Point_3> rounded(const Point_3& p) const
  {
    const internal::Vector x = internal::to_vector(p);
    if(!internal::is_in_range(x)) return std::nullopt;
    return internal::to_point(x, m_curve.traits());
  }

  const Curve_network& m_curve;
  internal::Network_editor<Curve_network> m_editor;
  internal::Exact_predicates<Traits> m_predicates{m_curve.traits()};
  Boundary m_boundary;
  internal::Edge_locator<Curve_network> m_locator{m_curve};
  internal::Local_change_certifier<Curve_network, Boundary> m_certifier{m_curve, m_predicates,
                                                                        m_locator, m_boundary};
  internal::Clearance_rule m_clearance;
  Bend_limits<Point_3> m_bends;
  std::unique_ptr<internal::Motion_record<Curve_network>> m_record;
  internal::Run_watch* m_watch = nullptr;
  size_type m_number_of_certified = 0;
  size_type m_number_of_refused = 0;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_ISOTOPY_GUARD_3_H
