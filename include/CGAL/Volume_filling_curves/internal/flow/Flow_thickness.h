// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_FLOW_THICKNESS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_FLOW_THICKNESS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/parameters/Thickness.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Thickness at the nodes of a flow's curve, the unit of its edges and steps.
template <typename Guard>
class Flow_thickness
{
public:
  using Thickness = internal::Thickness<typename Guard::Curve_network::Point_3>;

  // Takes the flow's parameters, whose thickness becomes the mean over the nodes. They must outlive
  // this object, as must the guard.
  Flow_thickness(Guard& guard, const Thickness& thickness, Curve_flow_parameters& parameters)
      : m_guard(guard), m_parameters(parameters), m_thickness(thickness)
  {}

  void set(const Thickness& thickness) { m_thickness = thickness; }

  // Evaluates the thickness at the nodes of the current curve.
  void update()
  {
    m_at_nodes = at_current_nodes();
    m_parameters.thickness = m_thickness.mean(m_at_nodes);
    // A step keeps strands a tenth of the thickness apart; closer ones could hardly move again.
    constexpr double clearance_over_thickness = 0.1;
    m_guard.set_clearance(m_at_nodes.empty() ? 0 : clearance_over_thickness * min());
  }

  std::vector<double> at_current_nodes() const
  {
    return m_thickness.at_each(m_guard.curve().points());
  }

  bool varies() const { return m_thickness.varies(); }

  const std::vector<double>& at_nodes() const { return m_at_nodes; }
  double min() const { return *std::min_element(m_at_nodes.begin(), m_at_nodes.end()); }

private:
  Guard& m_guard;
  Curve_flow_parameters& m_parameters;
  Thickness m_thickness;
  std::vector<double> m_at_nodes;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_FLOW_THICKNESS_H
