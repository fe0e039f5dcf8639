// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_PLAIN_GRID_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_PLAIN_GRID_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/replay/separating_directions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {
namespace replay {

// Hashed grid of boxes, for queries that need not visit all boxes. Two boxes that meet have a
// common cell, since the cell index is monotone in the coordinate. Boxes that cover many cells are
// in a separate list, which every query visits.
class Plain_grid
{
public:
  // Forgets all boxes.
  void reset(double cell_size, std::size_t expected_number)
  {
    m_cell_size = cell_size;
    std::size_t size = 16;
    while(size < 2 * expected_number) size *= 2;
    m_buckets.assign(size, {});
    m_large.clear();
  }

  void add(std::size_t item, const Extent& box)
  {
    const Cells cells = cells_of(box);
    if(number_of(cells) > max_cells) return m_large.push_back(item);
    for_each_bucket(cells, [&](Bucket& bucket) { bucket.push_back(item); });
  }

  // \pre the item was added with this box
  void remove(std::size_t item, const Extent& box)
  {
    const Cells cells = cells_of(box);
    if(number_of(cells) > max_cells) return take_out(m_large, item);
    for_each_bucket(cells, [&](Bucket& bucket) { take_out(bucket, item); });
  }

  // returns whether the boxes cover the same cells
  bool are_alike(const Extent& box1, const Extent& box2) const
  {
    return cells_of(box1) == cells_of(box2);
  }

  // Calls function(item) for all items whose boxes meet the given one, and some others, for some of
  // them several times. Returns false, having done nothing, if the box covers too many cells.
  template <typename Function>
  bool visit_cells(const Extent& box, const Function& function)
  {
    const Cells cells = cells_of(box);
    if(number_of(cells) > static_cast<double>(m_buckets.size())) return false;
    for(const std::size_t item : m_large) function(item);
    for_each_bucket(cells, [&](Bucket& bucket) {
      for(const std::size_t item : bucket) function(item);
    });
    return true;
  }

private:
  using Bucket = std::vector<std::size_t>;
  using Cells = std::array<std::array<std::int64_t, 2>, 3>; // the first and the last per coordinate

  static constexpr double max_cells = 64;       // of a box that is not large
  static constexpr double outermost_cell = 1e9; // coordinates beyond are in this one

  Cells cells_of(const Extent& box) const
  {
    Cells cells{};
    for(std::size_t k = 0; k < 3; ++k) cells[k] = {cell(box.lower[k]), cell(box.upper[k])};
    return cells;
  }

  std::int64_t cell(double x) const
  {
    const double index = std::floor(x / m_cell_size);
    return static_cast<std::int64_t>(
        (std::max)(-outermost_cell, (std::min)(outermost_cell, index)));
  }

  static double number_of(const Cells& cells)
  {
    double product = 1;
    for(const auto& range : cells) product *= static_cast<double>(range[1] - range[0] + 1);
    return product;
  }

  template <typename Function>
  void for_each_bucket(const Cells& cells, const Function& function)
  {
    for(std::int64_t i = cells[0][0]; i <= cells[0][1]; ++i)
      for(std::int64_t j = cells[1][0]; j <= cells[1][1]; ++j)
        for(std::int64_t k = cells[2][0]; k <= cells[2][1]; ++k)
          function(m_buckets[hash(i, j, k) & (m_buckets.size() - 1)]);
  }

  // multiples by odd numbers without a pattern, mixed
  static std::size_t hash(std::int64_t i, std::int64_t j, std::int64_t k)
  {
    const std::uint64_t x = static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15u +
                            static_cast<std::uint64_t>(j) * 0xc2b2ae3d27d4eb4fu +
                            static_cast<std::uint64_t>(k) * 0x165667b19e3779f9u;
    return static_cast<std::size_t>(x ^ x >> 29);
  }

  static void take_out(Bucket& bucket, std::size_t item)
  {
    const auto found = std::find(bucket.begin(), bucket.end(), item);
    *found = bucket.back();
    bucket.pop_back();
  }

  double m_cell_size = 1;
  std::vector<Bucket> m_buckets = std::vector<Bucket>(16);
  Bucket m_large;
};

} // namespace replay
} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_PLAIN_GRID_H
