// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_SEARCH_CHAIN_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_SEARCH_CHAIN_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/knots/Link_triviality.h>
#include <CGAL/Volume_filling_curves/internal/knots/Unknot_proofs.h>
#include <CGAL/Volume_filling_curves/internal/polygon_search/Polygon_walk.h>
#include <CGAL/Volume_filling_curves/internal/polygon_search/Search_parameters.h>
#include <CGAL/Volume_filling_curves/internal/polygon_search/Search_polygon.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Goal of a search: all components are closed with at most 5 edges, hence unknots (Randell 1994),
// and several components form a trivial link. Constant time while some component has more edges.
class Search_goal
{
public:
  template <typename Network>
  explicit Search_goal(const Network& curve)
  {
    for(std::size_t c = 0; c < curve.number_of_components(); ++c)
      m_is_possible = m_is_possible && curve.is_closed(c);
  }

  static bool has_small_components(const Search_polygon& polygon)
  {
    const auto& edges = polygon.edges_of_component();
    return std::all_of(edges.begin(), edges.end(), [](auto n) { return n <= edges_of_unknots; });
  }

  // Remembers that components are linked, since no search can change that.
  bool operator()(const Search_polygon& polygon)
  {
    if(!m_is_possible || !has_small_components(polygon)) return false;
    const std::size_t n = polygon.edges_of_component().size();
    if(n == 1) return true;
    const Curve_network_3<> curve = network(polygon);
    const Link_status status = Link_triviality<Curve_network_3<>>(curve)(
        std::vector<Unknot_proof>(n, Unknot_proof::EDGES));
    m_is_possible = status != Link_status::LINKED;
    return status == Link_status::TRIVIAL;
  }

private:
  static Curve_network_3<> network(const Search_polygon& polygon)
  {
    std::vector<Curve_network_3<>::Point_3> points;
    std::vector<std::array<std::size_t, 2>> edges;
    for(std::size_t v = 0; v < polygon.number_of_nodes(); ++v)
      points.push_back(
          to_point(polygon.position(static_cast<std::uint32_t>(v)), Curve_flow_traits_3<>()));
    polygon.for_each_edge([&](auto e) { edges.push_back({polygon.source(e), polygon.target(e)}); });
    return Curve_network_3<>(points, edges);
  }

  bool m_is_possible = true;
};

// Search for a curve with few edges: a random walk that restarts from its first curve when it stops
// making progress. It ends at the goal, after several restarts, or after a long time without
// progress. The chain stores the changes that led to the fewest edges, in bounded memory.
class Search_chain
{
  using Operations = Polygon_walk::Operations;

public:
  Search_chain(const Search_polygon& start,
               const Search_goal& goal,
               const Search_parameters& parameters,
               std::uint64_t seed)
      : m_parameters(parameters),
        m_goal(goal),
        m_walk(start, parameters, seed),
        m_reduced(m_walk.polygon()),
        m_number_of_reductions(m_walk.operations().size()),
        m_moves_until_end_of_round(start.number_of_edges())
  {
    note_best();
    m_progress = m_best_of_attempt;
    record();
    look_for_goal();
  }

  // Continues until `moves` moves have been tried in total, or the search has ended.
  void run(std::size_t moves)
  {
    while(m_moves < moves && !has_ended()) {
      m_walk.try_move();
      if(number_of_edges() < m_best_of_attempt.edges) {
        note_best();
        note_progress();
        look_for_goal();
      }
      ++m_moves;
      if(--m_moves_until_end_of_round == 0) end_round();
    }
  }

  bool has_ended() const
  {
    return m_has_reached_goal || m_walk.polygon().number_of_free_nodes() == 0 ||
           m_attempts_in_vain >= m_parameters.max_attempts_in_vain || m_has_given_up;
  }

  bool has_reached_goal() const { return m_has_reached_goal; }

  // the number of moves tried so far, and of sweeps, which are a hundred moves per edge
  std::size_t moves() const { return m_moves; }
  std::size_t sweeps() const { return m_rounds / rounds_per_sweep; }

  // Stores the best polygon of the current attempt if it has the fewest edges of all. Returns
  // whether it does.
  bool record()
  {
    if(m_best_of_attempt.edges >= m_best) return false;
    const auto begin = m_walk.operations().begin();
    m_best = m_best_of_attempt.edges;
    m_moves_to_best = m_best_of_attempt.moves;
    m_best_operations.assign(begin,
                             begin + static_cast<std::ptrdiff_t>(m_best_of_attempt.operations));
    return true;
  }

  // the fewest edges recorded, and the changes that lead to them
  std::size_t best() const { return m_best; }
  const Operations& best_operations() const { return m_best_operations; }

private:
  static constexpr std::size_t moves_between_looks = 256; // for whether the link is trivial
  static constexpr std::size_t rounds_per_sweep = 100;
  static constexpr std::size_t rounds_between_renumbering = 50;

  struct Record
  {
    std::size_t edges, operations, moves;
  };

  std::size_t number_of_edges() const { return m_walk.polygon().number_of_edges(); }

  void note_best() { m_best_of_attempt = {number_of_edges(), m_walk.operations().size(), m_moves}; }

  void note_progress()
  {
    const double edges = static_cast<double>(number_of_edges());
    if(edges <= Search_parameters::progress * static_cast<double>(m_progress.edges))
      m_progress = m_best_of_attempt;
  }

  // Returns whether the attempt has run out of patience or of memory.
  bool is_attempt_over() const
  {
    return m_moves - m_progress.moves > m_parameters.patience(m_progress.edges) ||
           m_walk.operations().size() - m_number_of_reductions >= m_parameters.max_operations;
  }

  void look_for_goal()
  {
    m_next_look = m_moves + moves_between_looks;
    if(!m_goal(m_walk.polygon())) return;
    m_has_reached_goal = true;
    m_best = number_of_edges();
    m_best_operations = m_walk.operations();
  }

  // A round has as many moves as there were edges at its start.
  void end_round()
  {
    ++m_rounds;
    if(m_rounds % rounds_between_renumbering == 0) m_walk.renumber();
    if(is_attempt_over())
      give_up();
    else if(m_moves >= m_next_look)
      look_for_goal();
    m_walk.measure();
    m_moves_until_end_of_round = number_of_edges();
  }

  // Ends the attempt, and the search after several attempts or many moves in vain.
  void give_up()
  {
    m_attempts_in_vain = record() ? 0 : m_attempts_in_vain + 1;
    m_has_given_up = m_moves - m_moves_to_best > m_parameters.max_moves_in_vain();
    m_walk.return_to(m_reduced, m_number_of_reductions);
    note_best();
    m_progress = m_best_of_attempt;
  }

  Search_parameters m_parameters;
  Search_goal m_goal;
  Polygon_walk m_walk;
  Search_polygon m_reduced; // the start of each attempt, after this many operations:
  std::size_t m_number_of_reductions;
  std::size_t m_moves = 0, m_rounds = 0, m_moves_until_end_of_round, m_next_look = 0;
  Record m_best_of_attempt = {0, 0, 0}, m_progress = {0, 0, 0};
  std::size_t m_best = static_cast<std::size_t>(-1), m_moves_to_best = 0;
  Operations m_best_operations;
  int m_attempts_in_vain = 0;
  bool m_has_reached_goal = false, m_has_given_up = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_SEARCH_CHAIN_H
