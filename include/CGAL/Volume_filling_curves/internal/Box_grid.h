// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_BOX_GRID_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_BOX_GRID_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Box.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Finds boxes near a box: a hash table of the cells of a uniform grid, each with a linked list of
// the boxes that reach into it. Boxes of a curve's edges are alike in size and spread out, so that
// inserting and querying take constant time; the few boxes that cover more than `max_cells` cells
// are kept in a list apart and met by every query. A box is found although it lies outside the grid
// that the first boxes suggested: cells are numbered without bounds.
class Box_grid
{
public:
  using Index = std::uint32_t;

  Box_grid() = default;

  // A cell size of zero or infinity stands for the nearest double in between.
  Box_grid(const Vector& origin, double cell_size, std::size_t expected_number_of_boxes)
      : m_origin(origin), m_cell_size(std::clamp(cell_size, least_cell_size, largest_cell_size))
  {
    std::size_t size = 64;
    while(size < 4 * expected_number_of_boxes) size *= 2;
    m_first.assign(size, end);
    m_entries.reserve(size);
  }

  bool is_empty() const { return m_entries.empty() && m_large.empty(); }

  void insert(std::size_t id, const Box& box)
  {
    const Cells cells = cells_of(box);
    if(cells.number() > max_cells) {
      m_large.push_back(static_cast<Index>(id));
      return;
    }
    cells.for_each([&](const Cell& cell) {
      const std::uint64_t key = hash(cell);
      Index& first = m_first[key & (m_first.size() - 1)];
      m_entries.push_back({key, static_cast<Index>(id), first});
      first = static_cast<Index>(m_entries.size() - 1);
    });
  }

  // Calls f(id) for every box that shares a cell with `box`, possibly more than once.
  template <typename Function>
  void for_each_near(const Box& box, const Function& f) const
  {
    for(Index id : m_large) f(id);
    const Cells cells = cells_of(box);
    if(cells.number() > static_cast<double>(m_entries.size())) {
      for(const Entry& entry : m_entries) f(entry.id);
      return;
    }
    cells.for_each([&](const Cell& cell) { for_each_in_cell(cell, f); });
  }

  // Calls f(j) once for every j < i whose box overlaps that of i. \pre boxes[k] was inserted as k
  // for all k, once.
  template <typename Function>
  void for_each_overlap_below(std::size_t i, const std::vector<Box>& boxes, const Function& f) const
  {
    const Box& box = boxes[i];
    const auto report = [&](Index j) {
      if(j < i && do_overlap(box, boxes[j])) f(j);
    };
    const Cells cells = cells_of(box);
    if(cells.number() > max_cells) { // i is in m_large, where the smaller ones need not be
      for(Index j = 0; j < i; ++j) report(j);
      return;
    }
    for(Index j : m_large) report(j);
    cells.for_each([&](const Cell& cell) {
      for_each_in_cell(cell, [&](Index j) {
        // of the cells that both share, the one with the lowest corner of the overlap reports
        if(j < i && do_overlap(box, boxes[j]) && cell_of(box.min.cwiseMax(boxes[j].min)) == cell)
          f(j);
      });
    });
  }

private:
  static constexpr Index end = static_cast<Index>(-1);
  static constexpr double max_cells = 64;
  static constexpr double least_cell_size = (std::numeric_limits<double>::min)();
  static constexpr double largest_cell_size = (std::numeric_limits<double>::max)();

  using Cell = std::array<std::int64_t, 3>;

  struct Cells
  {
    Cell first, last;

    double number() const
    {
      double n = 1;
      for(std::size_t k = 0; k < 3; ++k) n *= static_cast<double>(last[k] - first[k]) + 1;
      return n;
    }

    template <typename Function>
    void for_each(const Function& f) const
    {
      Cell cell;
      for(cell[0] = first[0]; cell[0] <= last[0]; ++cell[0])
        for(cell[1] = first[1]; cell[1] <= last[1]; ++cell[1])
          for(cell[2] = first[2]; cell[2] <= last[2]; ++cell[2]) f(cell);
    }
  };

  struct Entry
  {
    std::uint64_t key;
    Index id, next;
  };

  Cell cell_of(const Vector& p) const
  {
    Cell cell;
    for(int k = 0; k < 3; ++k) {
      constexpr double limit = 1e15; // far inside the integers that a double holds exactly
      const double index = std::floor((p[k] - m_origin[k]) / m_cell_size);
      cell[static_cast<std::size_t>(k)] =
          static_cast<std::int64_t>((std::min)((std::max)(index, -limit), limit));
    }
    return cell;
  }

  Cells cells_of(const Box& box) const { return {cell_of(box.min), cell_of(box.max)}; }

  static std::uint64_t hash(const Cell& cell)
  {
    std::uint64_t h = 0;
    for(std::int64_t c : cell) {
      h = (h ^ static_cast<std::uint64_t>(c)) * 0x9e3779b97f4a7c15u; // 2^64 over the golden ratio
      h ^= h >> 32;
    }
    return h;
  }

  template <typename Function>
  void for_each_in_cell(const Cell& cell, const Function& f) const
  {
    const std::uint64_t key = hash(cell);
    for(Index k = m_first[key & (m_first.size() - 1)]; k != end; k = m_entries[k].next)
      if(m_entries[k].key == key) f(m_entries[k].id);
  }

  Vector m_origin = Vector::Zero();
  double m_cell_size = 1;
  std::vector<Index> m_first = std::vector<Index>(1, end); // per hash value, into m_entries
  std::vector<Entry> m_entries;
  std::vector<Index> m_large;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_BOX_GRID_H
