// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_SURFACE_AREA_SPLIT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_SURFACE_AREA_SPLIT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

struct Numbered_box
{
  Bbox_3 box;
  std::uint32_t number;
};

// Divides boxes in two by a plane across an axis, on one side of which they have their centers. A
// random line that meets a hull meets a box in it with a probability that is the ratio of their
// surfaces (Cauchy, Crofton); so of some planes that is taken for which the sum of surface times
// number of boxes of either side is least (surface area heuristic; MacDonald and Booth 1990). Such
// planes are kept in few bins (Wald 2007), which takes linear time.
class Surface_area_split
{
public:
  using Boxes = std::vector<Numbered_box>;
  using Iterator = Boxes::iterator;

  // \pre there are at least two boxes
  Surface_area_split(Iterator first, Iterator beyond)
      : m_first(first),
        m_beyond(beyond),
        m_number_of_bins((std::min)(static_cast<std::size_t>(beyond - first), most_bins))
  {
    for(Iterator it = first; it != beyond; ++it) {
      m_low = m_low.cwiseMin(center(*it));
      m_high = m_high.cwiseMax(center(*it));
    }
  }

  // Puts the boxes of one side before those of the other, and returns where these begin. Neither
  // side is empty.
  Iterator operator()()
  {
    Plane best{0, 0, infinity};
    for(int axis = 0; axis < 3; ++axis)
      if(extent(axis) > 0) consider(axis, best);
    if(best.bin == 0 || best.cost == 0) return halve(); // equal centers, or no surface to save
    return std::partition(m_first, m_beyond,
                          [&](const Numbered_box& b) { return bin(b, best.axis) < best.bin; });
  }

  // the same, with as many boxes on either side, along the axis along which they reach farthest
  Iterator halve()
  {
    const std::array<int, 3> axes = {0, 1, 2};
    const int axis = *std::max_element(axes.begin(), axes.end(),
                                       [&](int i, int j) { return extent(i) < extent(j); });
    const Iterator middle = m_first + (m_beyond - m_first) / 2;
    std::nth_element(m_first, middle, m_beyond, [&](const Numbered_box& a, const Numbered_box& b) {
      return center(a, axis) < center(b, axis);
    });
    return middle;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::size_t most_bins = 16;

  struct Bin
  {
    Bbox_3 hull;
    std::size_t size = 0;
  };
  using Bins = std::array<Bin, most_bins>;

  struct Plane
  {
    int axis;
    std::size_t bin; // the first one beyond
    double cost;
  };

  static double center(const Numbered_box& b, int axis)
  {
    return b.box.min(axis) / 2 + b.box.max(axis) / 2;
  }

  static Vector center(const Numbered_box& b) { return {center(b, 0), center(b, 1), center(b, 2)}; }

  double extent(int axis) const { return m_high[axis] - m_low[axis]; }

  std::size_t bin(const Numbered_box& b, int axis) const
  {
    const double place = (center(b, axis) - m_low[axis]) / extent(axis);
    return (std::min)(static_cast<std::size_t>(place * static_cast<double>(m_number_of_bins)),
                      m_number_of_bins - 1);
  }

  void consider(int axis, Plane& best) const
  {
    Bins bins;
    for(Iterator it = m_first; it != m_beyond; ++it) add(bins[bin(*it, axis)], {it->box, 1});
    std::array<double, most_bins> cost_beyond;
    Bin beyond;
    for(std::size_t k = m_number_of_bins - 1; k > 0; --k) {
      add(beyond, bins[k]);
      cost_beyond[k] = cost(beyond);
    }
    Bin before;
    for(std::size_t k = 1; k < m_number_of_bins; ++k) {
      if(bins[k - 1].size == 0) continue; // the same as the plane before
      add(before, bins[k - 1]);
      const double sum = cost(before) + cost_beyond[k];
      if(sum < best.cost) best = {axis, k, sum};
    }
  }

  static void add(Bin& bin, const Bin& other)
  {
    bin.hull += other.hull;
    bin.size += other.size;
  }

  // \pre the bin is not empty
  static double cost(const Bin& bin)
  {
    const double x = bin.hull.xmax() - bin.hull.xmin();
    const double y = bin.hull.ymax() - bin.hull.ymin();
    const double z = bin.hull.zmax() - bin.hull.zmin();
    return (x * y + y * z + z * x) * static_cast<double>(bin.size);
  }

  Iterator m_first, m_beyond;
  std::size_t m_number_of_bins;
  // of the centers
  Vector m_low = Vector::constant(infinity), m_high = Vector::constant(-infinity);
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_SURFACE_AREA_SPLIT_H
