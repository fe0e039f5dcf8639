// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_HOMFLY_SKEIN_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_HOMFLY_SKEIN_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Laurent_polynomial_2.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Polynomial_work.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Tangle in a disk as a combination of descending tangles, by the HOMFLY-PT skein relation
// H(+) - H(-) = z H(0). A kink of sign e multiplies by v^-e, a split loop by (1/v - v) / z.
//
// The strands of a descending tangle lie in layers, and each is a straight chord of the disk in the
// plane. The incoming end of a strand has a rank, the number of its layer from 0 on top; the
// outgoing end has a label. A tangle is thus the list of labels by rank, and k strands have k!
// tangles, which form a basis (that of Hecke algebras, which have all incoming ends on one side;
// see Morton and Traczyk, Knots and Algebras, 1990). Every operation keeps the ranks equal for all
// tangles.
class Homfly_skein
{
public:
  // Makes an empty disk.
  explicit Homfly_skein(Polynomial_work& work) : m_work(work)
  {
    m_tangles.push_back({0, Laurent_polynomial_2::monomial({0, 0})});
  }

  // The factor of a split loop.
  static Laurent_polynomial_2 loop()
  {
    auto p = Laurent_polynomial_2::monomial({-1, -1});
    p.add_multiple(Laurent_polynomial_2::monomial({1, -1}, -1));
    return p;
  }

  // Rotates the ends, which are listed counterclockwise, to the left.
  void rotate(std::size_t by)
  {
    std::rotate(m_ends.begin(), m_ends.begin() + static_cast<std::ptrdiff_t>(by), m_ends.end());
  }

  // Adds a short strand below all others, whose ends become the ones at i and i + 1.
  void give_birth(std::size_t i, bool is_first_out)
  {
    const std::size_t rank = m_ends.size() / 2, label = free_label();
    if(rank == max_strands) throw Polynomial_limit();
    const End in{false, rank}, out{true, label};
    const std::array<End, 2> ends{is_first_out ? out : in, is_first_out ? in : out};
    m_ends.insert(m_ends.begin() + static_cast<std::ptrdiff_t>(i), ends.begin(), ends.end());
    for(Tangle& t : m_tangles) t.labels |= static_cast<Labels>(label) << (4 * rank);
  }

  // Crosses the strands that end at i and i + 1 outside, that at i above or below the other one.
  void cross(std::size_t i, bool is_first_over, int sign)
  {
    const End &e = m_ends[i], &f = m_ends[i + 1];
    if(e.is_out && f.is_out)
      cross_outs(is_first_over ? e.index : f.index, is_first_over ? f.index : e.index, sign);
    else if(!e.is_out && !f.is_out)
      lift_above(is_first_over ? e.index : f.index, is_first_over ? f.index : e.index);
    else
      cross_in_and_out(i, is_first_over != e.is_out, sign);
    std::swap(m_ends[i], m_ends[i + 1]);
  }

  // Joins the ends at i and i + 1, one incoming and one outgoing. The last join closes the last
  // loop, which counts as 1.
  void join(std::size_t i)
  {
    const std::size_t label = m_ends[i].is_out ? m_ends[i].index : m_ends[i + 1].index;
    const std::size_t in = m_ends[i].is_out ? i + 1 : i;
    move(m_ends[in].index, number_of_strands() - 1);
    std::vector<Tangle> done;
    close_loops(label, done);
    for(std::size_t rank = m_ends[in].index; rank > 0; --rank) {
      join_with_strand_above(rank, label, done);
      transpose(rank - 1);
    }
    CGAL_assertion(m_tangles.empty());
    m_tangles = std::move(done);
    collect();
    remove_ends(i);
  }

  // The polynomial of the closed tangle. \pre no end is left
  Laurent_polynomial_2 closed() const
  {
    return m_tangles.empty() ? Laurent_polynomial_2() : m_tangles.front().factor;
  }

private:
  using Labels = std::uint64_t; // four bits for each rank
  static constexpr std::size_t max_strands = 16;

  struct End
  {
    bool is_out;
    std::size_t index; // a rank if the strand comes in, else a label
  };

  struct Tangle
  {
    Labels labels;
    Laurent_polynomial_2 factor;
  };

  std::size_t number_of_strands() const { return m_ends.size() / 2; }

  static std::size_t label(Labels labels, std::size_t rank) { return labels >> (4 * rank) & 15; }

  static std::size_t rank_of(Labels labels, std::size_t label)
  {
    std::size_t rank = 0;
    while(Homfly_skein::label(labels, rank) != label) ++rank;
    return rank;
  }

  static Labels with_swapped(Labels labels, std::size_t r, std::size_t s)
  {
    const Labels difference = label(labels, r) ^ label(labels, s);
    return labels ^ difference << (4 * r) ^ difference << (4 * s);
  }

  // the labels without that of a rank
  static Labels without(Labels labels, std::size_t rank)
  {
    const Labels below = (Labels(1) << (4 * rank)) - 1;
    return (labels & below) | (labels >> 4 & ~below);
  }

  std::size_t free_label() const
  {
    std::size_t label = 0;
    const auto is_used = [&](const End& e) { return e.is_out && e.index == label; };
    while(std::any_of(m_ends.begin(), m_ends.end(), is_used)) ++label;
    return label;
  }

  std::size_t position(bool is_out, std::size_t index) const
  {
    std::size_t i = 0;
    while(m_ends[i].is_out != is_out || m_ends[i].index != index) ++i;
    return i;
  }

  // The sign of the crossing of two strands, of which the one with the smaller rank lies above; 0
  // if their chords do not cross.
  int crossing_sign(std::size_t upper, std::size_t lower, Labels labels) const
  {
    const std::size_t n = m_ends.size(), start = position(false, upper);
    const auto from_start = [&](std::size_t i) { return (i + n - start) % n; };
    const std::size_t end = from_start(position(true, label(labels, upper)));
    const std::size_t in = from_start(position(false, lower));
    const std::size_t out = from_start(position(true, label(labels, lower)));
    return (in < end) == (out < end) ? 0 : in < out ? 1 : -1;
  }

  // Adds a tangle to the terms, which are not yet sorted.
  void add(std::vector<Tangle>& tangles, Labels labels, Laurent_polynomial_2 factor)
  {
    m_work.use(1 + factor.terms().size());
    tangles.push_back({labels, std::move(factor)});
  }

  void add_multiple(std::vector<Tangle>& tangles,
                    Labels labels,
                    const Laurent_polynomial_2& factor,
                    std::array<int, 2> shift,
                    int sign)
  {
    Laurent_polynomial_2 multiple;
    multiple.add_multiple(factor, shift, sign);
    add(tangles, labels, std::move(multiple));
  }

  // Sorts the tangles and unites equal ones.
  void collect()
  {
    std::stable_sort(m_tangles.begin(), m_tangles.end(),
                     [](const Tangle& s, const Tangle& t) { return s.labels < t.labels; });
    std::vector<Tangle> united;
    for(Tangle& t : m_tangles)
      if(!united.empty() && united.back().labels == t.labels)
        united.back().factor.add_multiple(t.factor);
      else
        united.push_back(std::move(t));
    const auto is_zero = [](const Tangle& t) { return t.factor.is_zero(); };
    united.erase(std::remove_if(united.begin(), united.end(), is_zero), united.end());
    m_tangles = std::move(united);
  }

  // Swaps the layers r and r + 1: where their chords cross the crossing is switched, and the skein
  // relation adds the smoothed tangle, in which the two strands have exchanged their ends.
  void transpose(std::size_t r)
  {
    std::vector<Tangle> all;
    for(Tangle& t : m_tangles) {
      const int sign = crossing_sign(r, r + 1, t.labels);
      if(sign != 0) add_multiple(all, t.labels, t.factor, {0, 1}, sign);
      add(all, with_swapped(t.labels, r, r + 1), std::move(t.factor));
    }
    m_tangles = std::move(all);
    std::swap(m_ends[position(false, r)].index, m_ends[position(false, r + 1)].index);
    collect();
  }

  // Moves a strand from a layer to another one.
  void move(std::size_t rank, std::size_t to)
  {
    for(; rank < to; ++rank) transpose(rank);
    for(; rank > to; --rank) transpose(rank - 1);
  }

  // Crosses two neighboring incoming strands: if the upper one is in the lower layer, it is lifted,
  // after which the crossing agrees with the layers.
  void lift_above(std::size_t over, std::size_t under)
  {
    if(over > under) move(over, under);
  }

  // Crosses two neighboring outgoing strands: a crossing that disagrees with the layers is
  // switched; in the smoothed tangle the strands exchange their new ends.
  void cross_outs(std::size_t over, std::size_t under, int sign)
  {
    std::vector<Tangle> all;
    for(Tangle& t : m_tangles) {
      const std::size_t r = rank_of(t.labels, over), s = rank_of(t.labels, under);
      if(r > s) add_multiple(all, with_swapped(t.labels, r, s), t.factor, {0, 1}, sign);
      add(all, t.labels, std::move(t.factor));
    }
    m_tangles = std::move(all);
    collect();
  }

  // Crosses an incoming and an outgoing strand: the incoming one moves to the top or the bottom,
  // where it agrees with the crossing for any outgoing strand; if both are one strand, the crossing
  // is a kink.
  void cross_in_and_out(std::size_t i, bool is_in_over, int sign)
  {
    const std::size_t in = m_ends[i].is_out ? i + 1 : i;
    const std::size_t label = m_ends[i].is_out ? m_ends[i].index : m_ends[i + 1].index;
    move(m_ends[in].index, is_in_over ? 0 : number_of_strands() - 1);
    const std::size_t rank = m_ends[in].index;
    for(Tangle& t : m_tangles)
      if(Homfly_skein::label(t.labels, rank) == label) t.factor.shift({-sign, 0});
  }

  // Tangles in which the join closes the lowest strand to a split loop: it ends at the label.
  void close_loops(std::size_t label, std::vector<Tangle>& done)
  {
    const std::size_t lowest = number_of_strands() - 1;
    std::vector<Tangle> others;
    for(Tangle& t : m_tangles)
      if(Homfly_skein::label(t.labels, lowest) != label)
        others.push_back(std::move(t));
      else
        add(done, without(t.labels, lowest), lowest == 0 ? t.factor : t.factor * loop());
    m_tangles = std::move(others);
  }

  // Tangles in which the strand just above ends at the label and continues as the strand of that
  // rank: the two become one descending strand, with a kink if their chords cross.
  void join_with_strand_above(std::size_t rank, std::size_t label, std::vector<Tangle>& done)
  {
    std::vector<Tangle> others;
    for(Tangle& t : m_tangles) {
      if(Homfly_skein::label(t.labels, rank - 1) != label) {
        others.push_back(std::move(t));
        continue;
      }
      t.factor.shift({-crossing_sign(rank - 1, rank, t.labels), 0});
      add(done, without(t.labels, rank - 1), std::move(t.factor));
    }
    m_tangles = std::move(others);
  }

  // Removes the ends at i and i + 1, after their strand has come to rank 0.
  void remove_ends(std::size_t i)
  {
    const auto first = m_ends.begin() + static_cast<std::ptrdiff_t>(i);
    m_ends.erase(first, first + 2);
    for(End& e : m_ends)
      if(!e.is_out) --e.index;
  }

  std::vector<End> m_ends;
  std::vector<Tangle> m_tangles; // sorted by labels, none twice
  Polynomial_work& m_work;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_HOMFLY_SKEIN_H
