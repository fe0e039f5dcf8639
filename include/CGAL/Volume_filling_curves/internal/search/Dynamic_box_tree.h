// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_DYNAMIC_BOX_TREE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_DYNAMIC_BOX_TREE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Tree of changing boxes of any sizes, for overlap queries: nodes have 32 children in the order of
// the indices, which along a curve is a spatial order. Boxes are stored as 16-bit integers, of
// which the compiler tests eight at once; rounding down is monotone, hence boxes that overlap still
// do, and extra boxes do no harm. A query among a few hundred boxes takes tens of nanoseconds. A
// change takes logarithmic time, and allocates only if the number of boxes reaches a new maximum.
class Dynamic_box_tree
{
public:
  Dynamic_box_tree() : Dynamic_box_tree(Box()) {}

  // Takes the frame of most boxes; others are found with more candidates.
  explicit Dynamic_box_tree(const Box& frame) : m_origin(frame.min()), m_levels(1)
  {
    const double side = frame.sizes().maxCoeff();
    // an infinite scale would turn differences of zero into NaN
    m_scale = side > min_side ? number_of_steps / side : 0;
  }

  // for the boxes box_of(k), k < n, within `frame`
  template <typename Function>
  Dynamic_box_tree(const Box& frame, std::size_t n, const Function& box_of)
      : Dynamic_box_tree(frame)
  {
    m_size = n;
    store_level(0, n, [&](std::size_t k) { return rounded(box_of(k)); });
    for(std::size_t level = 0; m_levels[level].size() > 1; ++level) {
      m_levels.emplace_back();
      store_level(level + 1, m_levels[level].size(),
                  [&](std::size_t b) { return m_levels[level][b].hull(); });
    }
  }

  // Sets or changes box k. Those below it that were never set are empty.
  void set(std::size_t k, const Box& box) { store(k, rounded(box)); }

  // makes box k empty; no query finds it
  void clear(std::size_t k)
  {
    if(k < m_size) store(k, empty);
  }

  // Returns whether f(k) holds for every box k that overlaps `box`, and for those that nearly do
  // and are met on the way. Nothing is called after the first f(k) that does not hold.
  template <typename Predicate>
  bool holds_near(const Box& box, const Predicate& f) const
  {
    return visit(m_levels.size() - 1, 0, m_levels.back().size(), rounded(box), f);
  }

private:
  using Integer = std::int16_t;
  static constexpr std::size_t width = 32; // children of a node
  static constexpr std::int32_t half_of_steps = 32766;
  static constexpr double number_of_steps = 2 * half_of_steps;
  static constexpr double min_side = 1e-290;

  // the least x, y, z and the largest x, y, z
  using Rounded_box = std::array<Integer, 6>;
  static constexpr Rounded_box empty = {32767, 32767, 32767, -32767, -32767, -32767};

  // The boxes of the children of a node, coordinate after coordinate.
  struct Block
  {
    std::array<std::array<Integer, width>, 6> bounds;

    Block()
    {
      for(std::size_t i = 0; i < 6; ++i) bounds[i].fill(empty[i]);
    }

    void set(std::size_t k, const Rounded_box& box)
    {
      for(std::size_t i = 0; i < 6; ++i) bounds[i][k] = box[i];
    }

    Rounded_box hull() const
    {
      Rounded_box box = empty;
      for(std::size_t i = 0; i < 3; ++i)
        for(std::size_t k = 0; k < width; ++k) box[i] = (std::min)(box[i], bounds[i][k]);
      for(std::size_t i = 3; i < 6; ++i)
        for(std::size_t k = 0; k < width; ++k) box[i] = (std::max)(box[i], bounds[i][k]);
      return box;
    }

    using Flags = std::array<std::uint8_t, width>;

    Flags overlaps(const Rounded_box& box) const
    {
      // no branches: the compiler does this for eight children at once
      std::array<Integer, width> are_apart;
      for(std::size_t k = 0; k < width; ++k) {
        const int below =
            int(bounds[0][k] > box[3]) | int(bounds[1][k] > box[4]) | int(bounds[2][k] > box[5]);
        const int above =
            int(bounds[3][k] < box[0]) | int(bounds[4][k] < box[1]) | int(bounds[5][k] < box[2]);
        are_apart[k] = static_cast<Integer>(below | above);
      }
      Flags flags;
      for(std::size_t k = 0; k < width; ++k) flags[k] = are_apart[k] == 0;
      return flags;
    }
  };

  // Monotone in x, which is all that is needed. Infinity times zero stands for zero.
  Integer rounded(double x, int axis) const
  {
    const double steps = (x - m_origin[axis]) * m_scale;
    const double kept = steps > 0 ? (std::min)(steps, number_of_steps) : 0;
    return static_cast<Integer>(static_cast<std::int32_t>(kept) - half_of_steps);
  }

  Rounded_box rounded(const Box& box) const
  {
    const Vector &low = box.min(), &high = box.max();
    return {rounded(low.x(), 0),  rounded(low.y(), 1),  rounded(low.z(), 2),
            rounded(high.x(), 0), rounded(high.y(), 1), rounded(high.z(), 2)};
  }

  void store(std::size_t k, Rounded_box box)
  {
    m_size = (std::max)(m_size, k + 1);
    for(std::size_t level = 0;; ++level) {
      if(level == m_levels.size()) {
        m_levels.emplace_back();
        m_levels[level].emplace_back().set(0, m_levels[level - 1][0].hull());
      }
      auto& blocks = m_levels[level];
      const std::size_t b = k / width;
      if(b >= blocks.size()) blocks.resize(b + 1);
      blocks[b].set(k % width, box);
      if(blocks.size() == 1) return;
      box = blocks[b].hull();
      k = b;
    }
  }

  template <typename Function>
  void store_level(std::size_t level, std::size_t n, const Function& box_of)
  {
    m_levels[level].resize((n + width - 1) / width);
    for(std::size_t k = 0; k < n; ++k) m_levels[level][k / width].set(k % width, box_of(k));
  }

  template <typename Predicate>
  bool visit(std::size_t level,
             std::size_t begin,
             std::size_t end,
             const Rounded_box& box,
             const Predicate& f) const
  {
    for(std::size_t b = begin; b < end; ++b) {
      const typename Block::Flags flags = m_levels[level][b].overlaps(box);
      for(std::size_t first = 0; first < width; first += 8) {
        std::uint64_t eight;
        std::memcpy(&eight, flags.data() + first, 8);
        if(eight == 0) continue;
        for(std::size_t k = first; k < first + 8; ++k) {
          if(!flags[k]) continue;
          const std::size_t child = b * width + k;
          if(level == 0 ? !f(child) : !visit(level - 1, child, child + 1, box, f)) return false;
        }
      }
    }
    return true;
  }

  Vector m_origin;
  double m_scale;
  std::vector<std::vector<Block>> m_levels; // of the boxes, of their blocks, ...; the last has one
  std::size_t m_size = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_DYNAMIC_BOX_TREE_H
