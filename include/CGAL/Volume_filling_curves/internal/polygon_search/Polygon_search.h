// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_POLYGON_SEARCH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_POLYGON_SEARCH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Network_editor.h>
#include <CGAL/Volume_filling_curves/internal/polygon_search/Elementary_operation.h>
#include <CGAL/Volume_filling_curves/internal/polygon_search/Search_chain.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Reduction of a curve to few edges: independent searches with different seeds run concurrently,
// and a guard replays and certifies the moves of the best one. The best search reaches the goal
// with the fewest moves or, if none does, has the fewest edges. Hence the result depends on the
// seed, but not on threads and their timing. The run time of a search has a heavy tail, so several
// searches on as many threads end earlier than one.
template <typename Guard, typename ConcurrencyTag>
class Polygon_search
{
  using Network = typename Guard::Curve_network;

public:
  // \pre the network has no garbage
  Polygon_search(const Network& curve,
                 const Search_parameters& parameters,
                 std::size_t number_of_searches,
                 std::uint64_t seed)
  {
    const Search_polygon start(curve);
    const Search_goal goal(curve);
    Random_source seeds(seed);
    m_searches.reserve(number_of_searches);
    for(std::size_t k = 0; k < number_of_searches; ++k)
      m_searches.emplace_back(start, goal, parameters, seeds.bits());
  }

  // Searches until one search reaches the goal or all have ended. Calls go_further() every few
  // milliseconds, and stops and returns false if that does.
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

  // progress of the best search so far
  Search_progress progress() const { return {best().sweeps(), best().moves(), best().best()}; }

  // Returns the polygon that the best search found, for inspection only: no guard certifies it.
  // `start` is the curve from which the search started.
  Network uncertified_result(Network start) const
  {
    Network_editor<Network> editor(start);
    Uncertified_changes changes{start, editor};
    for(const Elementary_operation& operation : best().best_operations())
      carry_out(changes, operation);
    editor.collect_garbage();
    return start;
  }

  // Returns an upper estimate of the time of apply(), which takes 1 to 3 microseconds per change,
  // certificate included.
  double seconds_to_apply() const
  {
    constexpr double seconds_per_operation = 3e-6;
    return seconds_per_operation * static_cast<double>(best().best_operations().size());
  }

  // Replays the changes of the best search through a guard of the initial curve, or of a copy.
  // Calls go_further() every few milliseconds, and stops if that returns false. Leaves garbage in
  // the network.
  template <typename Predicate>
  void apply(Guard& guard, const Predicate& go_further) const
  {
    std::size_t k = 0;
    for(const Elementary_operation& operation : best().best_operations()) {
      if(++k % operations_between_looks == 0 && !go_further()) return;
      if(!carry_out(guard, operation)) return;
    }
  }

private:
  // changes without a guard, with the interface of one
  struct Uncertified_changes
  {
    using Point_3 = typename Network::Point_3;
    const Network& network;
    Network_editor<Network>& editor;

    const Network& curve() const { return network; }

    bool move_node(std::size_t v, const Point_3& target)
    {
      editor.move_node(v, target);
      return true;
    }

    bool insert_node(std::size_t e, const Point_3& position)
    {
      editor.insert_node(e, position);
      return true;
    }

    bool remove_node(std::size_t v)
    {
      editor.remove_node(v);
      return true;
    }
  };

  static constexpr std::size_t moves_per_round = 1 << 15;
  static constexpr std::size_t moves_between_looks = 256; // at other searches
  static constexpr std::size_t operations_between_looks = 1024;

  bool has_ended() const
  {
    const auto has_reached = [](const Search_chain& s) { return s.has_reached_goal(); };
    const auto is_over = [](const Search_chain& s) { return s.has_ended(); };
    return std::any_of(m_searches.begin(), m_searches.end(), has_reached) ||
           std::all_of(m_searches.begin(), m_searches.end(), is_over);
  }

  // A search may stop once another one has reached the goal with fewer moves.
  void run_round(std::size_t limit)
  {
    std::atomic<std::size_t> min_moves(limit);
    for_each_block<ConcurrencyTag>(m_searches.size(), 1, [&](std::size_t k, std::size_t) {
      Search_chain& search = m_searches[k];
      while(!search.has_ended() && search.moves() < min_moves)
        search.run((std::min)(search.moves() + moves_between_looks, limit));
      search.record();
      std::size_t least = min_moves;
      while(search.has_reached_goal() && search.moves() < least &&
            !min_moves.compare_exchange_weak(least, search.moves())) {
      }
    });
  }

  const Search_chain& best() const
  {
    const auto rank = [](const Search_chain& s) {
      return std::make_tuple(!s.has_reached_goal(), s.has_reached_goal() ? s.moves() : s.best());
    };
    return *std::min_element(
        m_searches.begin(), m_searches.end(),
        [&](const Search_chain& s, const Search_chain& t) { return rank(s) < rank(t); });
  }

  std::vector<Search_chain> m_searches;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_POLYGON_SEARCH_H
