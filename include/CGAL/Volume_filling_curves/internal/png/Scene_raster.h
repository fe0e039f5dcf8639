// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_PNG_SCENE_RASTER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_PNG_SCENE_RASTER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Triangle_soup.h>
#include <CGAL/Volume_filling_curves/internal/Vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// What is seen at each sample of a picture: the nearest point of a tube around the curve, and how
// much of a translucent surface lies in front of it and behind. The viewer looks along the z axis
// from far above (x to the right, y downwards, z towards the viewer). Tubes are chains of capsules,
// which are met exactly. The order of the surface's layers does not matter: their optical depths are
// added. Takes time linear in the number of samples covered.
class Scene_raster
{
public:
  struct Sample
  {
    float depth = -std::numeric_limits<float>::infinity(); // z of the tube
    float normal[3] = {0, 0, 0};                           // of the tube
    float in_front = 0, behind = 0;                        // optical depth of the surface
    std::size_t component = 0;

    bool has_tube() const { return std::isfinite(depth); }
  };

  Scene_raster(std::size_t width, std::size_t height)
      : m_width(width), m_height(height), m_samples(width * height)
  {}

  std::size_t width() const { return m_width; }
  std::size_t height() const { return m_height; }
  const Sample& sample(std::size_t x, std::size_t y) const { return m_samples[m_width * y + x]; }

  // Adds the points within `radius` of the segment ab.
  void add_capsule(const Vector& a, const Vector& b, double radius, std::size_t component)
  {
    const Vector margin(radius, radius, 0);
    for_each_sample(
        a.cwiseMin(b) - margin, a.cwiseMax(b) + margin,
        [&](double x, double y, Sample& sample) { add_to(sample, x, y, a, b, radius, component); });
  }

  // Adds a surface, with the normals at the corners of its triangles. \pre all tubes are there
  void add_surface(const Triangle_soup& soup, const std::vector<Vector>& corner_normals)
  {
    for(std::size_t t = 0; t < soup.triangles.size(); ++t) {
      const auto [a, b, c] = soup.triangles[t];
      add_triangle({soup.points[a], soup.points[b], soup.points[c]}, &corner_normals[3 * t]);
    }
  }

private:
  using Corners = std::array<Vector, 3>;

  // Samples lie in the middle of unit squares.
  template <typename Function>
  void for_each_sample(const Vector& min, const Vector& max, const Function& function)
  {
    const auto first = [](double x) { return static_cast<std::size_t>((std::max)(0., x + 0.5)); };
    const auto last = [&](double x, std::size_t size) {
      return static_cast<std::size_t>(std::clamp(x + 0.5, 0., static_cast<double>(size)));
    };
    for(std::size_t y = first(min.y()); y < last(max.y(), m_height); ++y)
      for(std::size_t x = first(min.x()); x < last(max.x(), m_width); ++x)
        function(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5,
                 m_samples[m_width * y + x]);
  }

  // The capsule is a union of balls around the points a + t (b - a); t is that of the ball whose
  // surface is nearest to the viewer at (x, y), a concave function of t.
  static void add_to(Sample& sample,
                     double x,
                     double y,
                     const Vector& a,
                     const Vector& b,
                     double radius,
                     std::size_t component)
  {
    const Vector d = b - a;
    const Eigen::Vector2d q(x - a.x(), y - a.y());
    const double flat2 = d.head<2>().squaredNorm();
    double t = d.z() > 0 ? 1 : 0;
    if(flat2 > 0) {
      const double foot = q.dot(d.head<2>()) / flat2;
      const double height2 = radius * radius - (q - foot * d.head<2>()).squaredNorm();
      if(height2 < 0) return;
      t = std::clamp(foot + d.z() * std::sqrt(height2 / (flat2 * d.squaredNorm())), 0., 1.);
    }
    const Eigen::Vector2d offset = q - t * d.head<2>();
    const double rise2 = radius * radius - offset.squaredNorm();
    if(rise2 < 0) return;
    const double rise = std::sqrt(rise2), depth = a.z() + t * d.z() + rise;
    if(!(depth > sample.depth)) return;
    sample.depth = static_cast<float>(depth);
    sample.normal[0] = static_cast<float>(offset.x() / radius);
    sample.normal[1] = static_cast<float>(offset.y() / radius);
    sample.normal[2] = static_cast<float>(rise / radius);
    sample.component = component;
  }

  void add_triangle(const Corners& p, const Vector* normals)
  {
    const auto area = [](const Vector& a, const Vector& b, double x, double y) {
      return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
    };
    const double total = area(p[0], p[1], p[2].x(), p[2].y());
    if(total == 0) return;
    for_each_sample(p[0].cwiseMin(p[1]).cwiseMin(p[2]), p[0].cwiseMax(p[1]).cwiseMax(p[2]),
                    [&](double x, double y, Sample& sample) {
                      const double u = area(p[1], p[2], x, y) / total;
                      const double v = area(p[2], p[0], x, y) / total, w = 1 - u - v;
                      if(u < 0 || v < 0 || w < 0) return;
                      const double depth = u * p[0].z() + v * p[1].z() + w * p[2].z();
                      const Vector n = u * normals[0] + v * normals[1] + w * normals[2];
                      const float opacity = optical_depth(std::abs(n.z()) / n.norm());
                      (depth > sample.depth ? sample.in_front : sample.behind) += opacity;
                    });
  }

  // More where the surface is seen at a grazing angle, as that of a soap bubble.
  static float optical_depth(double cosine)
  {
    constexpr double facing = 0.07, grazing = 0.6;
    const double sine = 1 - (std::min)(cosine, 1.);
    return static_cast<float>(facing + grazing * sine * sine * sine);
  }

  std::size_t m_width, m_height;
  std::vector<Sample> m_samples;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_PNG_SCENE_RASTER_H
