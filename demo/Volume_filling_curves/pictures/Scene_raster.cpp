// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/Scene_raster.h"

#include <Eigen/Core>

#include <algorithm>

namespace vfc {
namespace {

void set(Scene_raster::Sample& sample,
         double depth,
         const Vector& normal,
         double value,
         Scene_raster::Part part)
{
  sample.depth = static_cast<float>(depth);
  for(int k = 0; k < 3; ++k) sample.normal[k] = static_cast<float>(normal[k]);
  sample.value = static_cast<float>(value);
  sample.part = part;
}

// Returns the optical depth of a layer, larger at grazing angles, like that of a soap bubble.
float optical_depth(double cosine)
{
  constexpr double facing = 0.07, grazing = 0.6;
  const double sine = 1 - (std::min)(cosine, 1.);
  return static_cast<float>(facing + grazing * sine * sine * sine);
}

} // namespace

void Scene_raster::add(const Capsule& capsule)
{
  const Vector margin(capsule.radius, capsule.radius, 0);
  for_each_sample(capsule.a.cwiseMin(capsule.b) - margin, capsule.a.cwiseMax(capsule.b) + margin,
                  [&](double x, double y, Sample& sample) { add_at(x, y, capsule, sample); });
}

// The capsule is the union of the balls around the points a + t (b - a). The t of the visible ball,
// the one nearest to the viewer at (x, y), maximizes a concave function.
void Scene_raster::add_at(double x, double y, const Capsule& capsule, Sample& sample) const
{
  const auto& [a, b, radius, values, part] = capsule;
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
  if(m_cut && m_cut->height({x, y, depth}) > 0) return add_section_at(x, y, capsule, sample);
  if(!(depth > sample.depth)) return;
  set(sample, depth, Vector(offset.x(), offset.y(), rise) / radius,
      values[0] + t * (values[1] - values[0]), part);
}

// The part nearest to the viewer has been cut off. As the capsule is convex, the section is visible
// if the plane is inside the capsule at (x, y); otherwise nothing remains there.
void Scene_raster::add_section_at(double x, double y, const Capsule& capsule, Sample& sample) const
{
  const Vector& n = m_cut->normal;
  if(!(n.z() > 0)) return;
  const Vector p(x, y, (m_cut->offset - n.x() * x - n.y() * y) / n.z());
  const Vector d = capsule.b - capsule.a;
  const double length2 = d.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - capsule.a).dot(d) / length2, 0., 1.) : 0;
  if((p - capsule.a - t * d).norm() > capsule.radius) return;
  if(!(static_cast<float>(p.z()) > sample.depth)) return; // at equal depths the first capsule wins
  set(sample, p.z(), n, capsule.values[0] + t * (capsule.values[1] - capsule.values[0]),
      Part::SECTION);
}

void Scene_raster::add_surface(const Triangle_soup& soup, const std::vector<Vector>& corner_normals)
{
  for(std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const auto [a, b, c] = soup.triangles[t];
    add_triangle({soup.points[a], soup.points[b], soup.points[c]}, &corner_normals[3 * t]);
  }
}

void Scene_raster::add_triangle(const std::array<Vector, 3>& p, const Vector* normals)
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

// Samples are the centers of unit squares.
template <typename Function>
void Scene_raster::for_each_sample(const Vector& min, const Vector& max, const Function& function)
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

} // namespace vfc
