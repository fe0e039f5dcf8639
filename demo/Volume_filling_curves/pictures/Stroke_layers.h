// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_STROKE_LAYERS_H
#define VFC_STROKE_LAYERS_H

#include "pictures/Drawn_curve.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace vfc {

// Short piece of a curve in the picture.
struct Stroke_piece
{
  Vector source, target;
  std::size_t strand;
  double value;                             // shown as its color
  double begin, end;                        // along the strand
  std::size_t previous = none, next = none; // along the strand
  std::size_t layer = 0;
  bool is_over = false; // whether anything lies below it

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  double depth() const { return source.z() + target.z(); }
};

// Layers of the pieces of a curve: drawn one over the other, they show at every crossing which
// strand is above. Where the strokes of two pieces come close in the picture, the piece that is
// above at their closest points must be in a higher layer. The layers are the ranks of this partial
// order. Pieces then move to the layer of their neighbor along the strand if the order permits, so
// that a strand has few runs. O(n log n + k) for n pieces and k close pairs.
class Stroke_layers
{
public:
  // The color values of neighboring pieces differ by at most `value_step`, except where even the
  // shortest pieces differ by more.
  explicit Stroke_layers(const Drawn_curve& curve,
                         double value_step = std::numeric_limits<double>::infinity());

  const std::vector<Stroke_piece>& pieces() const { return m_pieces; }

  // The white gap beside the upper strand, in stroke widths.
  static constexpr double gap_share = 0.3;

private:
  using Index = std::uint32_t;

  // A strand as a whole: its length, and the points at its ends.
  struct Course
  {
    double length;
    bool is_closed;
    std::array<std::size_t, 2> ends;
  };

  void cut_into_pieces(const Drawn_curve& curve, const Strand& strand);
  int number_of_pieces(double length, double change) const;
  void link(std::size_t i, std::size_t j);
  bool are_neighbors(const Stroke_piece& a, const Stroke_piece& b) const;
  bool are_joined(const Stroke_piece& a, const Stroke_piece& b) const;
  double distance_to_end(const Stroke_piece& piece, std::size_t end) const;
  void find_order();
  void compare(Index i, Index j);
  void assign_layers();
  void join_layers();
  void follow(Index i, std::size_t neighbor);

  const double m_reach; // strokes with center lines farther apart do not touch
  const double m_value_step;
  std::vector<Stroke_piece> m_pieces;
  std::vector<Course> m_courses; // of the strands
  std::vector<std::vector<Index>> m_below, m_above;
};

} // namespace vfc

#endif // VFC_STROKE_LAYERS_H
