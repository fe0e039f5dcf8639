// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_CURVE_FLOW_3_H
#define CGAL_VOLUME_FILLING_CURVES_CURVE_FLOW_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/internal/bending/Shape_check.h>
#include <CGAL/Volume_filling_curves/internal/bending/Shape_goal.h>
#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/flow/Flow_direction.h>
#include <CGAL/Volume_filling_curves/internal/flow/Flow_motion.h>
#include <CGAL/Volume_filling_curves/internal/flow/Flow_thickness.h>
#include <CGAL/Volume_filling_curves/internal/flow/flow_parameters.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/parameters/Thickness.h>
#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Medial_spheres.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Field_vector.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Unbounded_domain_3.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief The class `Curve_flow_3` moves a curve, one certified step at a time: the curve gets
 * shorter while its strands keep an even distance.
 *
 * Each step follows the negative gradient of a two-term energy, length plus squared medial radii,
 * preconditioned by a sparse matrix whose pattern follows the medial spheres
 * \cgalCite{vfc:njs-mspku-25}. The step goes as far as `Isotopy_guard_3` certifies, and certified
 * remeshing follows. Between steps, all reading functions describe the current curve.
 *
 * The result does not depend on the number of threads. A step takes near-linear time.
 *
 * In a domain the curve stays strictly inside, and the boundary also limits the medial spheres: the
 * curve grows until it fills the domain evenly. The thickness may vary in space.
 *
 * The flow borrows the guard of the curve, which must outlive it. After other changes through the
 * guard, call `update()`.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3` with the point type of `Traits`
 * \tparam ConcurrencyTag enables parallel steps: `Sequential_tag` (default), `Parallel_tag` or
 * `Parallel_if_available_tag`
 */
template <typename Traits = Curve_flow_traits_3<>,
          typename Domain = Unbounded_domain_3<Traits>,
          typename ConcurrencyTag = Sequential_tag>
class Curve_flow_3
{
public:
  /// \name Types
  /// @{

  /// the type of the guard that certifies every step
  using Guard = Isotopy_guard_3<Traits, Domain>;

  /// the tag that enables parallel steps
  using Concurrency_tag = ConcurrencyTag;

  /// the type of the curve
  using Curve_network = Curve_network_3<Traits>;

  /// the type of points
  using Point_3 = typename Traits::Point_3;

  /// the type of the indices of nodes
  using size_type = typename Curve_network::size_type;

  /// a thickness that varies in space; must be safe to call concurrently, and return positive,
  /// finite values
  using Thickness_field = std::function<double(const Point_3&)>;

  /// a direction at each point, whose sign and length do not matter; zero where there is none
  using Direction_field = std::function<internal::Field_vector(const Point_3&)>;

  /// one vector per node: a matrix with a row for each, `x`, `y`, `z`
  using Vector_field = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

  /// @}

  /*!
   * prepares the flow of the guarded curve inside the guard's domain: measures the thickness if
   * none is given, and remeshes the curve, by certified operations, to the edge lengths that the
   * parameters require. The flow sets the clearance of the guard.
   *
   * Pinned nodes stay where they are, and sliding nodes move along their sets, see
   * `Node_constraint`. Steps move nodes on straight segments; hence nodes on lines and planes
   * deviate from these by the rounding of coordinates, and nodes near a bent boundary by less than
   * \f$s^2 / (8 \rho)\f$ from their distance, where \f$s\f$ is the length of a step and
   * \f$\rho\f$ the radius of curvature. Deviations do not add up.
   *
   * \param guard the guard of the curve
   * \param parameters \vfcNamedParams{Curve_flow_parameters}
   *
   * \pre the network has no garbage
   *
   * \throws std::invalid_argument if a parameter is out of its range, or if a node slides along the
   * boundary and there is no domain; if the curve is smaller than 1e-150 and no thickness is given;
   * or if the curve would have far more than 20 million nodes
   */
  explicit Curve_flow_3(Guard& guard,
                        const Curve_flow_parameters& parameters = Curve_flow_parameters())
      : Curve_flow_3(guard, parameters, Thickness(parameters.thickness))
  {}

  /// \cond SKIP_IN_MANUAL
  using Thickness = internal::Thickness<Point_3>;

  // A flow with a thickness that replaces the one in the parameters. A flow that is under way keeps
  // the edges of another flow, and waits for resume().
  Curve_flow_3(Guard& guard,
               const Curve_flow_parameters& parameters,
               const Thickness& thickness,
               bool is_under_way = false)
      : m_guard(guard),
        m_parameters(internal::checked(parameters, thickness)),
        m_state{guard.number_of_certified_changes(),
                guard.number_of_refused_changes(),
                {},
                internal::Step_size(parameters.max_displacement)},
        m_thickness(guard, thickness, m_parameters),
        m_motion(guard, m_thickness, m_parameters, m_state)
  {
    if(is_under_way) return;
    m_thickness.set(given_or_measured(m_parameters, thickness));
    start();
  }

  // Changes the largest displacement of a node in a step, in units of the thickness.
  void set_max_displacement(double max_displacement)
  {
    m_motion.set_max_displacement(max_displacement);
  }

  // Separates strands that are closer than the distance, in units of the least thickness, after
  // every step. By default only strands that block one another are separated, up to half of the
  // thickness.
  void keep_apart(double distance) { m_motion.keep_apart(distance); }
  /// \endcond

  Curve_flow_3(const Curve_flow_3&) = delete;
  Curve_flow_3& operator=(const Curve_flow_3&) = delete;

  /// changes the least length of an edge, in units of the thickness, and remeshes the curve to it.
  ///
  /// \pre the network has no garbage
  ///
  /// \throws std::invalid_argument if `spacing` is not positive, is larger than 1, or is so small
  /// that the curve would have far more than 20 million nodes
  void set_spacing(double spacing)
  {
    Curve_flow_parameters parameters = m_parameters;
    parameters.spacing = spacing;
    internal::check_parameters(parameters);
    internal::check_number_of_nodes(curve(), spacing, m_thickness.at_current_nodes());
    m_parameters = parameters;
    m_motion.remesh_until_even();
    update();
  }

  /// changes the parameters, and remeshes the curve to the edge lengths that they require.
  ///
  /// \pre the network has no garbage
  ///
  /// \throws std::invalid_argument like the constructor
  void set_parameters(const Curve_flow_parameters& parameters)
  {
    set_parameters(parameters, Thickness(parameters.thickness));
  }

  /// changes the parameters, with a thickness that varies in space instead of their `thickness`.
  ///
  /// \pre the network has no garbage
  ///
  /// \throws std::invalid_argument like the constructor, or if the thickness of a node is not
  /// positive and finite
  void set_parameters(const Curve_flow_parameters& parameters, Thickness_field thickness)
  {
    set_parameters(parameters, Thickness(parameters.thickness, std::move(thickness)));
  }

  /// \cond SKIP_IN_MANUAL
  void set_parameters(const Curve_flow_parameters& parameters, const Thickness& thickness)
  {
    const Curve_flow_parameters p = internal::checked(parameters, thickness);
    const Thickness given = given_or_measured(p, thickness);
    m_parameters = p;
    m_thickness.set(given);
    m_motion.start_anew();
    start();
  }

  // Brings the curve into limits of its shape in the steps from here on, see Shaped_step.
  void set_shape(const internal::Shape_goal& goal, internal::Shape_phase phase)
  {
    m_motion.set_shape(goal, phase);
  }

  // whether it keeps the limits
  bool is_shaped() const { return check_shape().is_passed(); }

  internal::Shape_check check_shape() const
  {
    return check_shape(m_motion.shape(), m_thickness.at_nodes());
  }

  // Compares the current curve with the limits of its shape.
  internal::Shape_check check_shape(const internal::Shape_goal& goal,
                                    const std::vector<double>& thickness) const
  {
    return {ConcurrencyTag(), curve(), internal::Shape_limits(curve(), goal, thickness)};
  }
  /// \endcond

  /*!
   * makes the curve follow a direction field: in the energy, the length of an edge at an angle
   * \f$\alpha\f$ to the field counts \f$1 + w \sin^2 \alpha\f$ times. Takes effect with the next
   * `update()`. An empty function stands for no field. In a planar domain, the field is projected
   * to the plane.
   *
   * \param field the field
   * \param weight the weight \f$w\f$, not negative, dimensionless
   *
   * \throws std::invalid_argument if the weight is negative or not finite
   */
  void set_direction_field(Direction_field field, double weight)
  {
    if(!(weight >= 0) || !std::isfinite(weight))
      throw std::invalid_argument(
          "the weight of a direction field must be finite and not negative");
    if(internal::Space_of<Domain>::is_plane && field)
      field = [in_space = std::move(field)](const Point_3& p) {
        const internal::Field_vector v = in_space(p);
        return internal::Field_vector::Array{v[0], v[1], 0};
      };
    m_direction.follow(std::move(field), weight);
  }

  /// moves the curve by one step, remeshes it, and returns whether it moved.
  ///
  /// \throws std::invalid_argument if a field returns a value out of its range. The curve may have
  /// moved then: before the next step, set another field, and call `update()` unless
  /// `set_parameters()` has set it.
  bool step()
  {
    ++m_state.statistics.iterations;
    const bool has_moved = m_motion(m_direction.positions(), direction());
    update();
    return has_moved;
  }

  /// updates the flow to the current curve. Call this function if the guard has changed the curve
  /// since the last step.
  ///
  /// \pre the network has no garbage
  ///
  /// \throws std::invalid_argument if a field returns a value out of its range
  void update()
  {
    CGAL_precondition_msg(!curve().has_garbage(), "the network has no garbage");
    m_thickness.update();
    m_direction.update(curve(), m_guard.boundary(), internal::in_domain<Domain>(m_parameters),
                       m_thickness.at_nodes(), m_state.statistics, m_guard.watch());
  }

  /// \cond SKIP_IN_MANUAL
  // An update() that counts the change as a step, for visitors, which see every state of a flow.
  void note_step()
  {
    ++m_state.statistics.iterations;
    update();
  }

  const internal::Flow_state& state() const { return m_state; }

  // Continues from the state of another flow of the same curve, with the same bits.
  void resume(const internal::Flow_state& state,
              const Curve_flow_parameters& parameters,
              const Thickness& thickness)
  {
    m_state = state;
    go_on(parameters, thickness);
  }

  // Changes parameters and thickness. Edges stay as they are.
  void go_on(const Curve_flow_parameters& parameters, const Thickness& thickness)
  {
    m_parameters = parameters;
    m_thickness.set(thickness);
    set_max_displacement(parameters.max_displacement);
    update();
  }
  /// \endcond

  /// \name Reading
  /// @{

  /// returns the network.
  const Curve_network& curve() const { return m_guard.curve(); }

  /// returns the parameters, with the measured thickness if none was given.
  const Curve_flow_parameters& parameters() const { return m_parameters; }

  /// returns the thickness r, in the input's unit; if it varies, the mean over the nodes.
  double thickness() const { return m_parameters.thickness; }

  /// returns the thickness at node `v`.
  double thickness(size_type v) const { return m_thickness.at_nodes()[v]; }

  /// returns the length of all edges.
  double length() const { return m_direction.length(); }

  /// returns the gradient of the energy at each node, along the set in which the node moves; zero
  /// at pinned nodes.
  const Vector_field& gradient() const { return m_direction.gradient(); }

  /// returns r times the sum of the norms of the nodes' gradients, divided by the sum of the nodes'
  /// shares of the length; pinned nodes are left out. Dimensionless, and independent of the
  /// spacing.
  double gradient_norm() const { return thickness() * m_direction.gradient_per_length(); }

  /// returns how loose the curve is: about 0.01 if it is tight, 1 if nothing resists its tension;
  /// then the thickness is too small for the curve. This is the sum of the norms of the nodes'
  /// gradients, divided by the same sum for the length alone, weighted by the direction field if
  /// there is one, or by 2 pi if that is more; pinned nodes are left out.
  double loose_share() const { return m_direction.loose_share(); }

  /// returns the mean of the medial radii along the curve, each capped at `largest`, in the input's
  /// unit; pinned nodes are left out.
  double mean_medial_radius(double largest = std::numeric_limits<double>::infinity()) const
  {
    return internal::mean_radius(m_direction.spheres(), m_direction.weights(), largest,
                                 [&](size_type v) { return !curve().is_pinned(v); });
  }

  /// returns the direction of the next step.
  const Vector_field& direction() const { return m_direction.vectors(); }

  /// returns the medial spheres of node `v`; ends, junctions and spikes have several circles of
  /// them.
  std::vector<Medial_sphere<Point_3>> medial_spheres(size_type v) const
  {
    return internal::medial_spheres_at(curve(), v, m_direction.spheres());
  }

  /// returns the work of the flow so far. Changes are those of the guard since the flow began.
  Curve_flow_statistics statistics() const
  {
    Curve_flow_statistics statistics = m_state.statistics;
    statistics.certified_changes =
        m_guard.number_of_certified_changes() - m_state.first_certified_change;
    statistics.refused_changes = m_guard.number_of_refused_changes() - m_state.first_refused_change;
    return statistics;
  }

  /// @}

private:
  Thickness given_or_measured(const Curve_flow_parameters& parameters,
                              const Thickness& thickness) const
  {
    return internal::given_or_measured<Domain, ConcurrencyTag>(m_guard, parameters, thickness);
  }

  void start()
  {
    m_motion.remesh_until_even();
    update();
  }

  Guard& m_guard;
  Curve_flow_parameters m_parameters;
  internal::Flow_state m_state;
  internal::Flow_thickness<Guard> m_thickness;
  internal::Flow_motion<Guard, ConcurrencyTag> m_motion;
  internal::Flow_direction<Curve_network, ConcurrencyTag> m_direction;
};

#ifndef DOXYGEN_RUNNING
template <typename Traits, typename Domain>
Curve_flow_3(Isotopy_guard_3<Traits, Domain>&,
             const Curve_flow_parameters& = Curve_flow_parameters())
    -> Curve_flow_3<Traits, Domain>;
#endif

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_CURVE_FLOW_3_H
