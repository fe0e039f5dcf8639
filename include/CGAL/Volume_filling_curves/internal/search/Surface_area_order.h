// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_SURFACE_AREA_ORDER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_SURFACE_AREA_ORDER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Order of boxes of any sizes, and its division into runs, that make a `Box_tree` fast. CGAL's AABB
// tree gives each child half of the runs, but runs of different lengths let a child have few or
// many boxes: long boxes are separated from short ones, whose hulls they would enlarge. A set is
// divided by the plane with the least surface area times number of boxes (Goldsmith and Salmon
// 1987) among those that leave enough runs for each side's boxes. O(n log n) time, O(log n) depth.
//
// Time of whole fillings, relative to a tree of our own divided by that plane without any
// constraint: 0.96 to 1.05 on nine domains, and 1.06, 1.04 and 1.33 on CAD meshes of slivers
// (79741, 88566, 520644 of Thingi10k). With runs of equal lengths, divided at the median, the
// latter are 1.25, 2.2 and 1.85.
class Surface_area_order
{
public:
  using Boxes = std::vector<Bbox_3>;

  explicit Surface_area_order(const Boxes& boxes) : m_boxes(boxes), m_numbers(boxes.size())
  {
    std::iota(m_numbers.begin(), m_numbers.end(), std::uint32_t(0));
    for(std::size_t axis = 0; axis < 3; ++axis)
      for(const Bbox_3& box : boxes) m_centers[axis].push_back(center(box, static_cast<int>(axis)));
    if(!boxes.empty())
      divide({0, boxes.size()}, (boxes.size() + mean_run_length - 1) / mean_run_length);
  }

  // the numbers of the boxes, in the order
  const std::vector<std::uint32_t>& numbers() const { return m_numbers; }

  // where each run ends, in the order; some are empty
  const std::vector<std::uint32_t>& run_ends() const { return m_run_ends; }

  // returns values, one for each box, in the order
  template <typename T>
  std::vector<T> sorted(const std::vector<T>& values) const
  {
    std::vector<T> sorted;
    sorted.reserve(values.size());
    for(const std::uint32_t i : m_numbers) sorted.push_back(values[i]);
    return sorted;
  }

private:
  static constexpr std::size_t mean_run_length = 4, max_run_length = 16, number_of_bins = 16;

  struct Range // of the order
  {
    std::size_t first, end;

    std::size_t size() const { return end - first; }
  };

  struct Interval // of the centers along an axis
  {
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();

    double length() const { return max - min; }
  };

  struct Bin
  {
    Bbox_3 hull;
    std::size_t size = 0;

    void add(const Bin& other)
    {
      hull += other.hull;
      size += other.size;
    }

    double cost() const
    {
      if(size == 0) return 0;
      const double x = hull.x_span(), y = hull.y_span(), z = hull.z_span();
      return (x * y + y * z + z * x) * static_cast<double>(size);
    }
  };
  using Bins = std::array<Bin, number_of_bins>;

  struct Plane
  {
    std::size_t axis;
    Interval centers;
    std::size_t bin; // the first one of the other side
    double cost;
  };

  static double center(const Bbox_3& box, int axis)
  {
    return box.min(axis) / 2 + box.max(axis) / 2;
  }

  // Divides boxes into a number of runs.
  void divide(const Range& range, std::size_t runs)
  {
    if(runs == 1) {
      m_run_ends.push_back(static_cast<std::uint32_t>(range.end));
      return;
    }
    constexpr std::size_t checked_runs = 256; // take a fraction of a millisecond
    if(runs > checked_runs) check_run();
    const std::size_t middle = split(range, runs);
    divide({range.first, middle}, runs / 2);
    divide({middle, range.end}, runs - runs / 2);
  }

  // Moves the boxes of the first half of the runs to the front, and returns where those of the
  // other half begin.
  std::size_t split(const Range& range, std::size_t runs)
  {
    const std::size_t capacity = max_run_length * (runs / 2),
                      rest = max_run_length * (runs - runs / 2);
    const std::size_t min_size = range.size() - (std::min)(range.size(), rest),
                      max_size = (std::min)(range.size(), capacity);
    std::optional<Plane> best;
    for(std::size_t axis = 0; axis < 3; ++axis) consider(range, axis, min_size, max_size, best);
    if(best) return partition(range, *best);
    const std::size_t size = (range.size() * (runs / 2) + runs - 1) / runs;
    return halve(range, range.first + (std::min)((std::max)(size, min_size), max_size));
  }

  void consider(const Range& range,
                std::size_t axis,
                std::size_t min_size,
                std::size_t max_size,
                std::optional<Plane>& best) const
  {
    const Interval centers = interval(range, axis);
    if(!(centers.length() > 0) || !std::isfinite(centers.length())) return;
    const Bins bins = filled_bins(range, axis, centers);
    std::array<double, number_of_bins> cost_beyond;
    Bin beyond;
    for(std::size_t k = number_of_bins - 1; k > 0; --k) {
      beyond.add(bins[k]);
      cost_beyond[k] = beyond.cost();
    }
    Bin before;
    for(std::size_t k = 1; k < number_of_bins; ++k) {
      before.add(bins[k - 1]);
      if(before.size < min_size || before.size > max_size) continue;
      const double cost = before.cost() + cost_beyond[k];
      if(!best || cost < best->cost) best = Plane{axis, centers, k, cost};
    }
  }

  Interval interval(const Range& range, std::size_t axis) const
  {
    Interval interval;
    for(std::size_t k = range.first; k < range.end; ++k) {
      const double center = m_centers[axis][m_numbers[k]];
      interval.min = (std::min)(interval.min, center);
      interval.max = (std::max)(interval.max, center);
    }
    return interval;
  }

  Bins filled_bins(const Range& range, std::size_t axis, const Interval& centers) const
  {
    Bins bins;
    for(std::size_t k = range.first; k < range.end; ++k)
      bins[bin(m_numbers[k], axis, centers)].add({m_boxes[m_numbers[k]], 1});
    return bins;
  }

  std::size_t bin(std::uint32_t number, std::size_t axis, const Interval& centers) const
  {
    const double fraction = (m_centers[axis][number] - centers.min) / centers.length();
    return (std::min)(static_cast<std::size_t>(fraction * number_of_bins), number_of_bins - 1);
  }

  std::size_t partition(const Range& range, const Plane& plane)
  {
    const auto middle = std::partition(at(range.first), at(range.end), [&](std::uint32_t i) {
      return bin(i, plane.axis, plane.centers) < plane.bin;
    });
    return static_cast<std::size_t>(middle - m_numbers.begin());
  }

  // along the axis along which the centers extend farthest
  std::size_t halve(const Range& range, std::size_t middle)
  {
    std::size_t longest = 0;
    for(std::size_t axis = 1; axis < 3; ++axis)
      if(interval(range, axis).length() > interval(range, longest).length()) longest = axis;
    const std::vector<double>& centers = m_centers[longest];
    std::nth_element(at(range.first), at(middle), at(range.end),
                     [&](std::uint32_t i, std::uint32_t j) { return centers[i] < centers[j]; });
    return middle;
  }

  std::vector<std::uint32_t>::iterator at(std::size_t k)
  {
    return std::next(m_numbers.begin(), static_cast<std::ptrdiff_t>(k));
  }

  const Boxes& m_boxes;
  std::vector<std::uint32_t> m_numbers, m_run_ends;
  std::array<std::vector<double>, 3> m_centers;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_SURFACE_AREA_ORDER_H
