// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_FLOW_DIRECTION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_FLOW_DIRECTION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/flow/Contact_stiffness.h>
#include <CGAL/Volume_filling_curves/internal/flow/Direction_preference.h>
#include <CGAL/Volume_filling_curves/internal/flow/Direction_solver.h>
#include <CGAL/Volume_filling_curves/internal/flow/Node_set.h>
#include <CGAL/Volume_filling_curves/internal/flow/energy_gradient.h>
#include <CGAL/Volume_filling_curves/internal/flow/preconditioner.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Boundary_limit.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Medial_sphere_search.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/support/Stage_timer.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Field_vector.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Direction of the flow of a curve: its medial spheres, the gradient of its energy, and the
// preconditioned direction (sections 3 and 4 of the paper).
template <typename Network, typename ConcurrencyTag>
class Flow_direction
{
  using Point_3 = typename Network::Point_3;

public:
  using Direction_field = std::function<Field_vector(const Point_3&)>;

  // Lets the curve follow a field from the next update on; an empty one stands for none.
  void follow(Direction_field field, double weight)
  {
    m_field = std::move(field);
    m_preference.weight = weight;
  }

  // Takes the boundary of the domain, the thickness at each node, and a watch, if there is one.
  // \throws Run_stopped: only the length, and the former gradient per length, are of use then
  template <typename Boundary>
  void update(const Network& curve,
              const Boundary& boundary,
              const Curve_flow_parameters& parameters,
              const std::vector<double>& thickness,
              Curve_flow_statistics& statistics,
              Run_watch* watch = nullptr)
  {
    m_positions = coordinates(curve);
    m_weights = node_weights(curve, m_positions);
    m_project = Tangent_projection(curve, boundary);
    m_length = std::accumulate(m_weights.begin(), m_weights.end(), 0.);
    update_spheres(curve, boundary, parameters, thickness, statistics, watch);
    const Stage_timer stage(statistics.seconds_direction);
    update_gradient(curve, parameters, thickness);
    m_vectors = m_solver(preconditioner<ConcurrencyTag>(parameters, curve, m_positions, m_weights,
                                                        thickness, m_spheres,
                                                        m_field ? &m_preference : nullptr),
                         -m_gradient, contacts(curve, parameters, thickness), m_project, watch);
  }

  const Vector_field& positions() const { return m_positions; }
  const std::vector<double>& weights() const { return m_weights; } // shares of the length
  const Medial_spheres& spheres() const { return m_spheres; }
  const Vector_field& gradient() const { return m_gradient; }
  const Vector_field& vectors() const { return m_vectors; }

  double length() const { return m_length; }

  // the sum of the norms of the nodes' gradients over that of their weights, pinned ones left out
  double gradient_per_length() const { return m_gradient_per_length; }

  // The sum of the norms of the gradients over that of length and direction field alone. A closed
  // curve turns by 2 pi at least (Fenchel 1929): a smaller sum, as of straight arcs, is rounding,
  // and counts as 2 pi.
  double loose_share() const { return m_free_pull / (std::max)(m_pull, 2 * CGAL_PI); }

private:
  template <typename Boundary>
  void update_spheres(const Network& curve,
                      const Boundary& boundary,
                      const Curve_flow_parameters& parameters,
                      const std::vector<double>& thickness,
                      Curve_flow_statistics& statistics,
                      Run_watch* watch)
  {
    const Stage_timer stage(statistics.seconds_medial_spheres);
    Medial_sphere_search search(ConcurrencyTag(), m_positions, thickness, parameters.max_radius,
                                boundary_limit(curve, boundary, parameters.wall), watch);
    m_spheres = search(node_circles(curve, m_positions), parameters.number_of_directions);
  }

  void update_gradient(const Network& curve,
                       const Curve_flow_parameters& parameters,
                       const std::vector<double>& thickness)
  {
    Energy_gradient<Network, ConcurrencyTag> gradient(curve, m_positions, m_weights);
    const auto tensions = component_tensions(curve, m_positions, m_weights, thickness);
    gradient.add_length(tensions);
    if(m_field) {
      m_preference.directions = edge_directions(curve, m_field);
      gradient.add_direction_preference(m_preference, tensions);
    }
    m_pull = sum_of_norms(gradient.projected(m_project));
    gradient.add_medial_spheres(m_spheres, thickness, parameters.medial_weight);
    m_gradient = gradient.projected(m_project);
    double weight = 0;
    for(std::size_t v = 0; v < m_weights.size(); ++v)
      if(!curve.is_pinned(v)) weight += m_weights[v];
    m_free_pull = sum_of_norms(m_gradient);
    m_gradient_per_length = weight > 0 ? m_free_pull / weight : 0;
  }

  Contact_stiffness contacts(const Network& curve,
                             const Curve_flow_parameters& parameters,
                             const std::vector<double>& thickness) const
  {
    if(parameters.preconditioner != Preconditioner::CONTACT) return {};
    return {curve, m_positions, m_weights, thickness, m_spheres, parameters.medial_weight};
  }

  Direction_field m_field;
  Direction_preference m_preference;
  Direction_solver<ConcurrencyTag> m_solver;
  Tangent_projection m_project;
  Vector_field m_positions, m_gradient, m_vectors;
  std::vector<double> m_weights; // per node
  Medial_spheres m_spheres;
  double m_length = 0, m_gradient_per_length = 0;
  double m_pull = 0, m_free_pull = 0; // of length and field, and what nothing resists; in radians
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_FLOW_DIRECTION_H
