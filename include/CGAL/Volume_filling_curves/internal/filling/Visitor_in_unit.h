// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_VISITOR_IN_UNIT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_VISITOR_IN_UNIT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/filling/scale.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Medial_spheres.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_visitor.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Thickness_fit.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// View of a Curve_flow_3 with all its reading functions, whose lengths are multiplied by a power of
// two.
template <typename Flow>
class Flow_in_unit
{
public:
  using Guard = typename Flow::Guard;
  using Concurrency_tag = typename Flow::Concurrency_tag;
  using Curve_network = typename Flow::Curve_network;
  using Point_3 = typename Flow::Point_3;
  using size_type = typename Flow::size_type;
  using Vector_field = typename Flow::Vector_field;

  Flow_in_unit(const Flow& flow, double unit)
      : m_flow(flow),
        m_unit(unit),
        m_curve(scaled(flow.curve(), unit)),
        m_parameters(flow.parameters()),
        m_direction(unit * flow.direction())
  {
    m_parameters.thickness *= unit;
  }

  const Curve_network& curve() const { return m_curve; }
  const Curve_flow_parameters& parameters() const { return m_parameters; }
  double thickness() const { return m_unit * m_flow.thickness(); }
  double thickness(size_type v) const { return m_unit * m_flow.thickness(v); }
  double length() const { return m_unit * m_flow.length(); }
  const Vector_field& gradient() const { return m_flow.gradient(); } // dimensionless
  double gradient_norm() const { return m_flow.gradient_norm(); }
  double loose_share() const { return m_flow.loose_share(); }
  const Vector_field& direction() const { return m_direction; }
  Curve_flow_statistics statistics() const { return m_flow.statistics(); }

  double mean_medial_radius(double largest = std::numeric_limits<double>::infinity()) const
  {
    return m_unit * m_flow.mean_medial_radius(largest / m_unit);
  }

  std::vector<Medial_sphere<Point_3>> medial_spheres(size_type v) const
  {
    std::vector<Medial_sphere<Point_3>> spheres = m_flow.medial_spheres(v);
    for(auto& sphere : spheres) {
      sphere.center = scaled(sphere.center, m_unit, m_curve.traits());
      sphere.radius *= m_unit;
    }
    return spheres;
  }

private:
  const Flow& m_flow;
  const double m_unit;
  Curve_network m_curve;
  Curve_flow_parameters m_parameters;
  Vector_field m_direction;
};

// A visitor of a run that measures lengths in a unit of its own: shows the caller's visitor the
// flow in the caller's unit, which is the flow itself if the units are the same.
template <typename Flow, typename Visitor>
class Visitor_in_unit final : public Run_visitor<Flow>
{
public:
  Visitor_in_unit(Visitor& visitor, double unit) : m_visitor(visitor), m_unit(unit) {}

  void on_start(const Flow& flow) override
  {
    show(flow, [this](const auto& shown) { m_visitor.on_start(shown); });
  }

  void on_iteration(const Flow& flow) override
  {
    show(flow, [this](const auto& shown) { m_visitor.on_iteration(shown); });
  }

  bool go_further(const Flow& flow) override
  {
    return show(flow, [this](const auto& shown) { return m_visitor.go_further(shown); });
  }

  void on_thin_domain(const Thickness_fit& fit) override
  {
    Thickness_fit shown = fit;
    scale(shown, m_unit);
    Watched_scope::outside([&] { m_visitor.on_thin_domain(shown); });
  }

  bool on_search(const Search_progress& progress) override { return m_visitor.on_search(progress); }

private:
  template <typename Show>
  auto show(const Flow& flow, const Show& show) const
  {
    return Watched_scope::outside(
        [&] { return m_unit == 1 ? show(flow) : show(Flow_in_unit<Flow>(flow, m_unit)); });
  }

  Visitor& m_visitor;
  const double m_unit;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_VISITOR_IN_UNIT_H
