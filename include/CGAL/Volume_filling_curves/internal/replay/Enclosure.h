// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_ENCLOSURE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_ENCLOSURE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/format.h>

#include <array>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {
namespace replay {

// The enclosure that a replayed curve must not leave.
class Enclosure
{
public:
  virtual ~Enclosure() = default;

  // returns whether p lies strictly inside
  virtual bool is_inside(const Position& p) const = 0;

  // returns whether the closed triangle, which may be degenerate, lies strictly inside.
  // \pre its first corner does
  virtual bool is_triangle_inside(const std::array<Position, 3>& triangle) const = 0;
};

// Enclosure by the answers of a domain, a model of VolumeFillingDomain_3, which are trusted.
template <typename Domain>
class Domain_enclosure final : public Enclosure
{
  using Point_3 = typename Domain::Point_3;

public:
  explicit Domain_enclosure(const Domain& domain) : m_domain(domain) {}

  bool is_inside(const Position& p) const override { return m_domain.is_inside(point(p)); }

  bool is_triangle_inside(const std::array<Position, 3>& triangle) const override
  {
    return m_domain.is_triangle_inside(point(triangle[0]), point(triangle[1]), point(triangle[2]));
  }

private:
  static Point_3 point(const Position& p) { return Point_3(p[0], p[1], p[2]); }

  const Domain& m_domain;
};

} // namespace replay
} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_ENCLOSURE_H
