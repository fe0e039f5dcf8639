// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "symmetry/Symmetry.h"

#include "meshes/vertex_values.h"
#include "options/lists.h"
#include "session/errors.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace vfc {
namespace {

constexpr double pi = 3.141592653589793;
constexpr std::size_t max_order = 1000;

[[noreturn]] void complain(const std::string& text)
{
  throw Usage_error("--symmetry: " + text +
                    ": is neither mirror[:X,Y,Z,NX,NY,NZ] nor rotation:K[:X,Y,Z,AX,AY,AZ] with K "
                    "from 2 to " +
                    std::to_string(max_order));
}

// 0 if the text is not a number from 2 to the largest order
std::size_t parsed_order(const std::string& text)
{
  const bool are_digits =
      std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c); });
  if(text.empty() || text.size() > 4 || !are_digits) return 0;
  const std::size_t order = std::stoul(text);
  return order < 2 || order > max_order ? 0 : order;
}

// Scales by a power of two first, since the square of a component may leave the range of numbers.
Symmetry::Vector unit(const Symmetry::Vector& v)
{
  const int exponent = -std::ilogb((std::max)({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())}));
  const auto scaled = [&](double x) { return std::scalbn(x, exponent); };
  const Symmetry::Vector w(scaled(v.x()), scaled(v.y()), scaled(v.z()));
  return w / std::sqrt(w.squared_length());
}

bool is_finite(const Symmetry::Point& p)
{
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

} // namespace

Symmetry::Symmetry(const std::string& text, const CGAL::Bbox_3& box)
{
  const std::string mirror = "mirror", rotation = "rotation:";
  std::string rest;
  m_is_mirror = text.compare(0, mirror.size(), mirror) == 0;
  if(m_is_mirror) {
    rest = text.substr(mirror.size());
  } else {
    if(text.compare(0, rotation.size(), rotation) != 0) complain(text);
    const std::size_t end = (std::min)(text.find(':', rotation.size()), text.size());
    m_order = parsed_order(text.substr(rotation.size(), end - rotation.size()));
    if(m_order == 0) complain(text);
    rest = text.substr(end);
  }
  const Point middle((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2,
                     (box.zmin() + box.zmax()) / 2);
  std::array<double, 3> p{middle.x(), middle.y(), middle.z()};
  std::array<double, 3> d{m_is_mirror ? 1. : 0., 0, m_is_mirror ? 0. : 1.};
  if(!rest.empty()) {
    const std::size_t end = find_comma(rest, 3);
    if(rest[0] != ':' || end == std::string::npos || !parse_vector(rest.substr(1, end - 1), p) ||
       !parse_vector(rest.substr(end + 1), d))
      complain(text);
  }
  m_origin = Point(p[0], p[1], p[2]);
  const Vector direction(d[0], d[1], d[2]);
  if(direction == CGAL::NULL_VECTOR) complain(text);
  m_direction = unit(direction);
  // the coordinate axis that is the least parallel to the direction
  const Vector axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Vector across = axes[0];
  for(const Vector& axis : axes)
    if(std::abs(axis * m_direction) < std::abs(across * m_direction)) across = axis;
  m_across = unit(across - (across * m_direction) * m_direction);
  m_sideways = CGAL::cross_product(m_direction, m_across);
  if(!is_finite(image(middle, 1)))
    throw Usage_error("--symmetry: " + text + ": is too far from the mesh");
}

Symmetry::Point Symmetry::image(const Point& p, std::size_t k) const
{
  if(k == 0) return p;
  const Vector v = p - m_origin;
  if(m_is_mirror) return p - 2 * (v * m_direction) * m_direction;
  return m_origin + rotated(v, static_cast<double>(k) * angle_of_sector());
}

std::vector<Symmetry::Side> Symmetry::sides() const
{
  if(m_is_mirror) return {{m_origin, m_direction}};
  std::vector<Side> sides{{m_origin, m_sideways}};
  if(m_order > 2) sides.push_back({m_origin, -rotated(m_sideways, angle_of_sector())});
  return sides;
}

Symmetry::Point Symmetry::point_of_cut(double s, double t) const
{
  return m_origin + s * m_across + t * (m_is_mirror ? m_sideways : m_direction);
}

// Rodrigues' formula; exact for half a turn about a coordinate axis.
Symmetry::Vector Symmetry::rotated(const Vector& v, double angle) const
{
  const Vector along = (v * m_direction) * m_direction;
  if(m_order == 2 && angle == pi) return 2 * along - v;
  return along + std::cos(angle) * (v - along) +
         std::sin(angle) * CGAL::cross_product(m_direction, v);
}

double Symmetry::angle_of_sector() const
{
  return 2 * pi / static_cast<double>(m_order);
}

} // namespace vfc
