// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_ISOTOPY_GUARD_3_H
#define CGAL_VOLUME_FILLING_CURVES_ISOTOPY_GUARD_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/Unbounded_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/Certified_motion.h>
#include <CGAL/Volume_filling_curves/internal/Grid_broad_phase.h>
#include <CGAL/Volume_filling_curves/internal/Local_change_certifier.h>
#include <CGAL/Volume_filling_curves/internal/Vector.h>
#include <CGAL/Volume_filling_curves/internal/Walls.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief The class `Isotopy_guard_3` is the only way to change a `Curve_network_3`: it carries out
 * a change if and only if it can certify it.
 *
 * A change is certified with exact predicates to be an ambient isotopy: the curve passes at no time
 * through itself. Everything is built from the elementary moves of knot theory
 * \cgalCite{vfc:r-ebt-26}: replacing an edge by two sides of a triangle that meets the rest of the
 * curve only in the ends of the edge, or the reverse. Degenerate positions are decided exactly, too.
 * For open curves the certificate says that no strand passes through another; a strand may slip off
 * an end.
 *
 * On request the guard also keeps a clearance: it refuses changes that bring edges without a common
 * node closer than a given distance and closer than half the distance that they had, or close the
 * angle between edges with a common node below 20 degrees and to less than about half of what it
 * was. Curves that land on contact can hardly move again. The clearance is no part of the certificate.
 *
 * Inserting and removing nodes leaves gaps in the numbering, which `collect_garbage()` closes.
 *
 * Positions are rounded to `double` before they are certified; those that are not finite are
 * refused.
 *
 * The guard borrows the network, which must outlive it and must not be assigned to. A network can
 * have several guards. Guards of different networks can be used concurrently.
 *
 * \pre the network is embedded: two of its edges meet at most in a common node
 *
 * With a domain, everything that the curve sweeps must lie strictly inside it as well: a curve that
 * starts inside stays inside, as exactly as the domain can tell.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3` with the same point type
 */
template <typename Traits = Curve_flow_traits_3<>, typename Domain = Unbounded_domain_3<Traits>>
class Isotopy_guard_3
{
public:
  /// \name Types
  /// @{

  /// the type of the curve
  using Curve_network = Curve_network_3<Traits>;

  /// the type of points
  using Point_3 = typename Traits::Point_3;

  /// the type of the indices of nodes and edges
  using size_type = typename Curve_network::size_type;

  /// @}

  /// constructs a guard of `curve` without a domain.
  explicit Isotopy_guard_3(Curve_network& curve)
      : m_curve(curve),
        m_predicates(curve.traits()),
        m_locator(curve),
        m_certifier(curve, m_predicates, m_locator, m_walls)
  {}

  /// constructs a guard of `curve`, which keeps it inside `domain`. The guard borrows the domain,
  /// which must outlive it.
  ///
  /// \pre the curve lies inside `domain`
  Isotopy_guard_3(Curve_network& curve, const Domain& domain)
      : m_curve(curve),
        m_predicates(curve.traits()),
        m_walls(domain),
        m_locator(curve),
        m_certifier(curve, m_predicates, m_locator, m_walls)
  {}

  Isotopy_guard_3(const Isotopy_guard_3&) = delete;
  Isotopy_guard_3& operator=(const Isotopy_guard_3&) = delete;

  /// returns the guarded network.
  const Curve_network& curve() const { return m_curve; }

  /// sets the distance that edges without a common node keep, in the input's unit; 0 (default)
  /// stands for no clearance at all. Edges that are closer already may halve their distance.
  void set_clearance(double distance) { m_clearance = internal::Clearance_rule(distance); }

  /// \name Certified Operations
  /// @{

  /// moves node `v` to `target` if that is certified, and returns whether it did. Pinned nodes move,
  /// too: pins are for the flow.
  ///
  /// \pre the node has not been removed
  bool move_node(size_type v, const Point_3& target)
  {
    CGAL_precondition_msg(!m_curve.is_removed_node(v), "the node has not been removed");
    return count(is_finite(target) && move_node_if_safe(v, rounded(target)));
  }

  /// replaces edge `e` by two edges to a new node at `position` if that is certified, and returns
  /// whether it did. The edge from `source(e)` keeps the index `e`; the new node is the last one.
  ///
  /// \pre the edge has not been removed
  bool insert_node(size_type e, const Point_3& position)
  {
    CGAL_precondition_msg(!m_curve.is_removed_edge(e), "the edge has not been removed");
    return count(is_finite(position) && insert_node_if_safe(e, rounded(position)));
  }

  /// removes node `v` and joins its two neighbors by an edge if that is certified, and returns
  /// whether it did. Ends, junctions and pinned nodes stay, and a closed component keeps 3 edges.
  bool remove_node(size_type v) { return count(remove_node_if_safe(v)); }

  /*!
   * moves all nodes towards their targets, as far as that is certified.
   *
   * Tries the fractions 1, 1/2, 1/4, ... of the way down to `least_fraction`.
   *
   * \tparam ConcurrencyTag enables a parallel run (`Parallel_tag`); the result is the same
   * \tparam BroadPhase finds the pairs of edges to be tested
   *
   * \param targets one row per node with its x, y and z
   * \param least_fraction the least fraction of the way to be tried
   *
   * \returns the fraction of the way that the nodes went, 0 if none was certified
   *
   * \pre the network has no garbage
   * \pre `targets` has one row per node
   * \pre `least_fraction` is positive
   */
  template <typename ConcurrencyTag = Sequential_tag,
            typename BroadPhase = internal::Grid_broad_phase<Curve_network>>
  double move_nodes(const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>& targets,
                    double least_fraction = 1)
  {
    const size_type n = m_curve.number_of_nodes();
    CGAL_precondition_msg(!m_curve.has_garbage(), "the network has no garbage");
    CGAL_precondition_msg(static_cast<size_type>(targets.rows()) == n,
                          "`targets` has one row per node");
    CGAL_precondition_msg(least_fraction > 0, "`least_fraction` is positive");
    if(!targets.allFinite()) {
      m_number_of_rejected += n;
      return 0;
    }
    const internal::Certified_motion<Curve_network, Walls, BroadPhase, ConcurrencyTag> motion(
        m_curve, targets, m_clearance, m_walls);
    for(double fraction = 1; fraction >= least_fraction; fraction /= 2) {
      if(motion.keeps_clearance(fraction)) {
        auto rounds = motion.certify(fraction);
        if(!rounds.positions.empty()) {
          record_rounds(rounds.positions, rounds.is_reversed);
          replace_points(std::move(rounds.positions.back()));
          m_number_of_certified += n;
          return fraction;
        }
      }
      m_number_of_rejected += n;
    }
    return 0;
  }

  /// multiplies all coordinates by two to the power of `exponent` if that is exact, that is, if no
  /// coordinate over- or underflows, and returns whether it did. Not with a domain.
  bool scale_by_power_of_two(int exponent)
  {
    static_assert(!Walls::is_bounded, "Scaling does not keep the curve inside a domain");
    std::vector<Point_3> scaled;
    scaled.reserve(m_curve.number_of_nodes());
    const double factor = std::ldexp(1., exponent), inverse = std::ldexp(1., -exponent);
    for(const Point_3& point : m_curve.m_points) {
      const internal::Vector x = internal::to_vector(point), y = factor * x;
      if(inverse * y != x) return false;
      scaled.push_back(internal::to_point(y, m_curve.traits()));
    }
    if(m_curve.m_record) m_curve.m_record->scale_by_power_of_two(exponent);
    replace_points(std::move(scaled));
    return true;
  }

  /// @}

  /// closes the gaps that removed nodes left, numbers the nodes along the curve again, and returns
  /// the former index of each node.
  std::vector<std::uint32_t> collect_garbage()
  {
    std::vector<Point_3> points;
    points.reserve(m_curve.number_of_nodes());
    std::vector<std::uint32_t> former = m_curve.m_topology.compact();
    for(std::uint32_t v : former) points.push_back(m_curve.m_points[v]);
    if(m_curve.m_record) m_curve.m_record->renumber(former);
    replace_points(std::move(points));
    return former;
  }

  /// \name Certificate
  /// The record of all changes belongs to the network: those that other guards make are recorded,
  /// too, and a copy of the network takes the record along.
  /// @{

  /// starts to record all changes of the network from here on; a former record is forgotten.
  ///
  /// \pre the network has no garbage
  void start_recording()
  {
    CGAL_precondition_msg(!m_curve.has_garbage(), "the network has no garbage");
    m_curve.m_record.emplace(m_curve);
  }

  /// stops to record changes, and forgets the record.
  void stop_recording() { m_curve.m_record.reset(); }

  /// returns whether changes of the network are recorded.
  bool is_recording() const { return m_curve.m_record.has_value(); }

  /// returns the certificate of the motion from where the recording has started to the network as
  /// it stands. The recording goes on. Takes time linear in the length of the record.
  ///
  /// \pre changes are recorded
  Isotopy_certificate certificate() const
  {
    CGAL_precondition_msg(is_recording(), "changes are recorded");
    return Isotopy_certificate(m_curve.m_record->certificate(m_curve));
  }

  /// @}

  /// \name Statistics
  /// @{

  /// returns how many changes of a node were certified and carried out.
  size_type number_of_certified_changes() const { return m_number_of_certified; }

  /// returns how many changes of a node were refused.
  size_type number_of_refused_changes() const { return m_number_of_rejected; }

  /// @}

  /// \cond SKIP_IN_MANUAL
  using Walls = internal::Walls<Domain>;

  const Walls& walls() const { return m_walls; }
  /// \endcond

private:
  bool count(bool is_certified)
  {
    ++(is_certified ? m_number_of_certified : m_number_of_rejected);
    return is_certified;
  }

  static bool is_finite(const Point_3& p) { return internal::to_vector(p).allFinite(); }

  Point_3 rounded(const Point_3& p) const
  {
    return internal::to_point(internal::to_vector(p), m_curve.traits());
  }

  // the curve has changed altogether
  void replace_points(std::vector<Point_3> points)
  {
    m_curve.m_points = std::move(points);
    m_locator.reset();
    m_revision = ++m_curve.m_revision;
  }

  // the edge has changed
  void update_edge(size_type e)
  {
    m_locator.update(e);
    m_revision = ++m_curve.m_revision;
  }

  // Forgets the edges if another guard has changed some since.
  void notice_changes()
  {
    if(m_revision == m_curve.m_revision) return;
    m_locator.reset();
    m_revision = m_curve.m_revision;
  }

  bool move_node_if_safe(size_type v, const Point_3& target)
  {
    notice_changes();
    if(m_predicates.are_equal(m_curve.point(v), target)) return true;
    if(!m_certifier.is_move_safe(v, target, m_clearance)) return false;
    if(m_curve.m_record) m_curve.m_record->move_node(v, target);
    m_curve.m_points[v] = target;
    for(size_type k = 0; k < m_curve.degree(v); ++k) update_edge(m_curve.incident_edge(v, k));
    return true;
  }

  bool insert_node_if_safe(size_type e, const Point_3& b)
  {
    notice_changes();
    if(!m_certifier.is_insertion_safe(e, b, m_clearance)) return false;
    if(m_curve.m_record) m_curve.m_record->insert_node(m_curve.source(e), m_curve.target(e), b);
    m_curve.m_topology.insert_node(e);
    m_curve.m_points.push_back(b);
    update_edge(e);
    update_edge(m_curve.number_of_edges() - 1);
    return true;
  }

  bool remove_node_if_safe(size_type v)
  {
    notice_changes();
    if(m_curve.is_pinned(v) || !m_certifier.is_removal_safe(v, m_clearance)) return false;
    if(m_curve.m_record) m_curve.m_record->remove_node(v);
    update_edge(m_curve.m_topology.remove_node(v));
    return true;
  }

  // The rounds have been certified node by node, and so they are recorded.
  void record_rounds(const std::vector<std::vector<Point_3>>& rounds, bool is_reversed)
  {
    if(!m_curve.m_record) return;
    const std::vector<Point_3>* before = &m_curve.m_points;
    for(const std::vector<Point_3>& after : rounds) {
      for(size_type k = 0; k < after.size(); ++k) {
        const size_type v = is_reversed ? after.size() - 1 - k : k;
        if(!m_predicates.are_equal((*before)[v], after[v]))
          m_curve.m_record->move_node(v, after[v]);
      }
      before = &after;
    }
  }

  Curve_network& m_curve;
  internal::Exact_predicates<Traits> m_predicates;
  Walls m_walls;
  internal::Edge_locator<Curve_network> m_locator;
  internal::Local_change_certifier<Curve_network, Walls> m_certifier;
  internal::Clearance_rule m_clearance;
  size_type m_revision = 0; // of the curve when it was last looked at
  size_type m_number_of_certified = 0;
  size_type m_number_of_rejected = 0;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_ISOTOPY_GUARD_3_H
