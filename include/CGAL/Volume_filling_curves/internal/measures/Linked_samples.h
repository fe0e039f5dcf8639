// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_LINKED_SAMPLES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_LINKED_SAMPLES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/support/Disjoint_sets.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Samples of a domain, joined where they are close and the segment between them lies inside.
// Samples of one set are certainly connected inside the domain; samples of different sets are
// probably not, unless a passage is narrower than the distance between samples. A grid finds close
// samples. Near-linear time.
template <typename Domain>
class Linked_samples
{
  using Point_3 = typename Domain::Point_3;

public:
  // `spacing` is the edge of the cube, or the square, that holds one sample on average.
  // \throws Run_stopped if a watch requests it
  Linked_samples(const Domain& domain,
                 const std::vector<Point_3>& samples,
                 double spacing,
                 Run_watch* watch = nullptr)
      : m_domain(domain), m_samples(samples), m_link(link_length * spacing), m_sets(samples.size())
  {
    std::map<Cell, std::vector<std::size_t>> cells;
    for(std::size_t k = 0; k < samples.size(); ++k) {
      check(watch);
      const Cell c = cell(to_vector(samples[k]));
      for(long long x = c[0] - 1; x <= c[0] + 1; ++x)
        for(long long y = c[1] - 1; y <= c[1] + 1; ++y)
          for(long long z = c[2] - 1; z <= c[2] + 1; ++z)
            if(const auto found = cells.find({x, y, z}); found != cells.end())
              link_to_near(k, found->second);
      cells[c].push_back(k);
    }
  }

  // the sets, which callers may unite further
  Disjoint_sets& sets() { return m_sets; }

  // the largest distance of samples that are linked
  double link() const { return m_link; }

private:
  using Cell = std::array<long long, 3>;

  // Within this many spacings a sample has 14 neighbors on average; random gaps do not tear a
  // region apart.
  static constexpr double link_length = Space_of<Domain>::is_plane ? 2.1 : 1.5;

  Cell cell(const Vector& p) const
  {
    // numbers of cells must fit integers; farther cells, of slivers far from the origin, are one
    constexpr double end = 1e18;
    const auto number = [&](double x) {
      return std::llround(std::clamp(std::floor(x / m_link), -end, end));
    };
    return {number(p.x()), number(p.y()), number(p.z())};
  }

  void link_to_near(std::size_t k, const std::vector<std::size_t>& others)
  {
    const Point_3& p = m_samples[k];
    for(const std::size_t j : others) {
      const Point_3& q = m_samples[j];
      if((to_vector(p) - to_vector(q)).squaredNorm() > m_link * m_link) continue;
      if(m_sets.find(j) == m_sets.find(k)) continue;
      if(m_domain.is_triangle_inside(p, q, q)) m_sets.unite(j, k);
    }
  }

  const Domain& m_domain;
  const std::vector<Point_3>& m_samples;
  double m_link;
  Disjoint_sets m_sets;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_LINKED_SAMPLES_H
