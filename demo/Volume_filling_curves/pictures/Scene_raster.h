// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_SCENE_RASTER_H
#define VFC_SCENE_RASTER_H

#include "pictures/Triangle_soup.h"
#include "pictures/cuts.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace vfc {

// Raster of a scene: at each sample of a picture, the nearest point of a tube around the curve, and
// the amount of a translucent surface in front of it and behind it. The viewer looks along the z
// axis from far above (x to the right, y downwards, z towards the viewer). Tubes are chains of
// capsules; their intersections with the line of sight are exact. The order of the surface's layers
// does not matter: their optical depths are added. A cut leaves the part of each tube in a
// half-space, with visible sections. Takes time linear in the number of covered samples.
class Scene_raster
{
public:
  enum class Part : unsigned char
  {
    TUBE,
    SECTION, // of a tube
    LINE     // of one color
  };

  // A part of a curve: all points within the radius of a segment.
  struct Capsule
  {
    Vector a, b;
    double radius;
    std::array<double, 2> values = {0, 0}; // shown as colors, at a and at b
    Part part = Part::TUBE;
  };

  struct Sample
  {
    float depth = -std::numeric_limits<float>::infinity(); // z of the tube
    float normal[3] = {0, 0, 0};                           // of the tube
    float in_front = 0, behind = 0;                        // optical depth of the surface
    float value = 0;                                       // shown as color
    Part part = Part::TUBE;

    bool has_tube() const { return std::isfinite(depth); }
  };

  Scene_raster(std::size_t width, std::size_t height)
      : m_width(width), m_height(height), m_samples(width * height)
  {}

  // Cuts all tubes added later. \pre the viewer does not see the plane from behind
  void set_cut(const Half_space& half_space) { m_cut = half_space; }

  std::size_t width() const { return m_width; }
  std::size_t height() const { return m_height; }
  const Sample& sample(std::size_t x, std::size_t y) const { return m_samples[m_width * y + x]; }

  void add(const Capsule& capsule);

  // Adds a surface, with the normals at the corners of its triangles. \pre all tubes have been
  // added
  void add_surface(const Triangle_soup& soup, const std::vector<Vector>& corner_normals);

private:
  template <typename Function>
  void for_each_sample(const Vector& min, const Vector& max, const Function& function);

  void add_triangle(const std::array<Vector, 3>& corners, const Vector* normals);

  void add_at(double x, double y, const Capsule& capsule, Sample& sample) const;
  void add_section_at(double x, double y, const Capsule& capsule, Sample& sample) const;

  std::size_t m_width, m_height;
  std::optional<Half_space> m_cut;
  std::vector<Sample> m_samples;
};

} // namespace vfc

#endif // VFC_SCENE_RASTER_H
