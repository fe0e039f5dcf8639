// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_TIGHTENER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_TIGHTENER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Untangling_strategy.h>
#include <CGAL/Volume_filling_curves/internal/Elementary_operation.h>
#include <CGAL/Volume_filling_curves/internal/Tightening_search.h>
#include <CGAL/Volume_filling_curves/internal/for_each_block.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Tightens a curve: independent searches with seeds of their own run at the same time, and what the
// best of them did is done again through the guard, which certifies it once more. The first to reach
// the goal, counted in moves, is the best; if none does, the one that gets to the fewest edges. Hence
// the result depends on the seed, but not on threads and their timing. The time that a search takes
// has a heavy tail, so that several of them end earlier than one does, on threads of their own.
template <typename Guard, typename ConcurrencyTag>
class Tightener
{
  using Network = typename Guard::Curve_network;

public:
  // \pre the network has no garbage
  Tightener(Guard& guard,
            const Tightening_parameters& parameters,
            std::size_t number_of_searches,
            std::uint64_t seed)
      : m_guard(guard)
  {
    const Tightening_polygon start(guard.curve());
    const Tightening_goal goal(guard.curve());
    Random_source seeds(seed);
    m_searches.reserve(number_of_searches);
    for(std::size_t k = 0; k < number_of_searches; ++k)
      m_searches.emplace_back(start, goal, parameters, seeds.bits());
  }

  // Searches until the goal is reached or all searches are exhausted, or go_further() returns false,
  // which is asked every few milliseconds. Returns whether it never did.
  template <typename Predicate>
  bool run(const Predicate& go_further)
  {
    for(std::size_t limit = moves_per_round; !has_ended(); limit += moves_per_round) {
      if(!go_further()) return false;
      run_round(limit);
    }
    return true;
  }

  bool has_reached_goal() const { return best().has_reached_goal(); }

  // of the search that got farthest, so far
  Tightening_progress progress() const { return {best().sweeps(), best().moves(), best().best()}; }

  // Carries out what the best search did. Leaves garbage in the network.
  void apply()
  {
    for(const Elementary_operation& operation : best().best_operations())
      if(!carry_out(m_guard, operation)) return;
  }

private:
  static constexpr std::size_t moves_per_round = 1 << 15;
  static constexpr std::size_t moves_between_looks = 256; // at the other searches

  bool has_ended() const
  {
    const auto has_reached = [](const Tightening_search& s) { return s.has_reached_goal(); };
    const auto is_over = [](const Tightening_search& s) { return s.has_ended(); };
    return std::any_of(m_searches.begin(), m_searches.end(), has_reached) ||
           std::all_of(m_searches.begin(), m_searches.end(), is_over);
  }

  // A search that others have overtaken may stop: it cannot be the first one any more.
  void run_round(std::size_t limit)
  {
    std::atomic<std::size_t> least_moves(limit);
    for_each_block<ConcurrencyTag>(m_searches.size(), 1, [&](std::size_t k, std::size_t) {
      Tightening_search& search = m_searches[k];
      while(!search.has_ended() && search.moves() < least_moves)
        search.run((std::min)(search.moves() + moves_between_looks, limit));
      search.record();
      std::size_t least = least_moves;
      while(search.has_reached_goal() && search.moves() < least &&
            !least_moves.compare_exchange_weak(least, search.moves())) {
      }
    });
  }

  const Tightening_search& best() const
  {
    const auto rank = [](const Tightening_search& s) {
      return std::make_tuple(!s.has_reached_goal(), s.has_reached_goal() ? s.moves() : s.best());
    };
    return *std::min_element(
        m_searches.begin(), m_searches.end(),
        [&](const Tightening_search& s, const Tightening_search& t) { return rank(s) < rank(t); });
  }

  Guard& m_guard;
  std::vector<Tightening_search> m_searches;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_TIGHTENER_H
