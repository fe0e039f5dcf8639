// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Fills a user-defined domain, a model of VolumeFillingDomain_3.

#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/fill.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace VFC = CGAL::Volume_filling_curves;

using Traits = VFC::Curve_flow_traits_3<>;
using Curve = VFC::Curve_network_3<Traits>;

//! [domain]
// A solid cylinder around the z-axis
class Cylinder
{
public:
  using Point_3 = Traits::Point_3;
  using Vector_3 = Traits::Vector_3;

  Cylinder(double radius, double height) : m_radius(radius), m_height(height) {}

  CGAL::Bbox_3 bbox() const { return {-m_radius, -m_radius, 0, m_radius, m_radius, m_height}; }

  // Excludes a thin layer, since the distance is rounded.
  bool is_inside(const Point_3& p) const { return distance(p) > 1e-12 * (m_radius + m_height); }

  // A triangle lies in a convex set if its corners do.
  bool is_triangle_inside(const Point_3& p, const Point_3& q, const Point_3& r) const
  {
    return is_inside(p) && is_inside(q) && is_inside(r);
  }

  double distance(const Point_3& p) const
  {
    return (std::max)(0.,
                      (std::min)({m_radius - std::hypot(p.x(), p.y()), p.z(), m_height - p.z()}));
  }

  double distance_along(const Point_3& p, const Vector_3& u, double limit) const
  {
    // to the mantle, where |p + t u| = radius in the plane: a t^2 + 2 b t = c
    const double a = u.x() * u.x() + u.y() * u.y(), b = p.x() * u.x() + p.y() * u.y();
    const double c = m_radius * m_radius - p.x() * p.x() - p.y() * p.y();
    double t = a > 0 ? (std::sqrt(b * b + a * c) - b) / a : limit;
    if(u.z() > 0) t = (std::min)(t, (m_height - p.z()) / u.z());
    if(u.z() < 0) t = (std::min)(t, p.z() / -u.z());
    return (std::min)(t, limit);
  }

private:
  double m_radius, m_height;
};
//! [domain]

int main()
{
  const Cylinder cylinder(0.5, 1);
  Curve curve; // empty: fill() starts where the domain is widest
  const auto result = VFC::fill(curve, cylinder, VFC::parameters::thickness(0.15));

  const VFC::Domain_samples_3 samples(cylinder);
  const auto coverage =
      VFC::coverage(samples, VFC::sample_distances(curve, samples), result.thickness);
  std::cout << result.status << ", " << 100 * coverage.fraction_within_r
            << " % of the volume are within " << result.thickness << " of the curve\n";
  return coverage.fraction_within_r > 0.7 ? EXIT_SUCCESS : EXIT_FAILURE;
}
