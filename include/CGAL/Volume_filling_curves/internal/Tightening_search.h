// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_TIGHTENING_SEARCH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_TIGHTENING_SEARCH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Elementary_operation.h>
#include <CGAL/Volume_filling_curves/internal/Tightening_goal.h>
#include <CGAL/Volume_filling_curves/internal/Tightening_parameters.h>
#include <CGAL/Volume_filling_curves/internal/Tightening_polygon.h>
#include <CGAL/Volume_filling_curves/internal/generators/Random_source.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// A random search for the fewest edges of a curve: certified random changes of single nodes, where
// shorter curves are always welcome and longer ones now and then (Metropolis et al. 1953), from time
// to time a node more, and nodes less wherever that is possible. The polygon stays coarse, hence the
// moves are long, and what a flow cannot untie comes undone. A search that gets nowhere starts again.
// About half a microsecond per move for a hundred edges.
class Tightening_search
{
  using Index = Tightening_polygon::Index;
  using Operations = std::vector<Elementary_operation>;

public:
  Tightening_search(const Tightening_polygon& start,
                    const Tightening_goal& goal,
                    const Tightening_parameters& parameters,
                    std::uint64_t seed)
      : m_parameters(parameters), m_goal(goal), m_random(seed), m_reduced(start), m_polygon(start)
  {
    measure();
    reduce();
    m_reduced = m_polygon;
    m_number_of_reductions = m_operations.size();
    start_attempt();
    record();
    m_is_exhausted = m_polygon.number_of_free_nodes() == 0;
    look_for_goal();
  }

  // Goes on until so many moves have been proposed in all, or the search has ended.
  void run(std::size_t moves)
  {
    while(m_moves < moves && !has_ended()) {
      propose();
      ++m_moves;
      if(--m_moves_until_end_of_round == 0) end_round();
    }
  }

  bool has_ended() const { return m_has_reached_goal || m_is_exhausted; }
  bool has_reached_goal() const { return m_has_reached_goal; }

  // the number of moves proposed so far, and how often a hundred per edge
  std::size_t moves() const { return m_moves; }
  std::size_t sweeps() const { return m_rounds / rounds_per_sweep; }

  // Remembers the fewest edges of the current attempt if they are the fewest of all, and returns
  // whether they are.
  bool record()
  {
    if(m_best_of_attempt.edges >= m_best) return false;
    m_best = m_best_of_attempt.edges;
    m_best_operations.assign(m_operations.begin(),
                             m_operations.begin() +
                                 static_cast<std::ptrdiff_t>(m_best_of_attempt.operations));
    return true;
  }

  // the fewest edges that were recorded, and how to get there
  std::size_t best() const { return m_best; }
  const Operations& best_operations() const { return m_best_operations; }

private:
  static constexpr std::size_t moves_between_looks = 256; // whether the link is trivial
  static constexpr std::size_t rounds_per_sweep = 100;
  static constexpr std::size_t rounds_between_renumbering = 50; // while edges change their places

  struct Record
  {
    std::size_t edges, operations, moves;
  };

  void propose()
  {
    const Index v = m_polygon.free_node(m_random.index(m_polygon.number_of_free_nodes()));
    double choice = m_random.real();
    if((choice -= m_parameters.removal_rate) < 0)
      remove(v);
    else if((choice -= m_parameters.insertion_rate) < 0)
      insert(m_polygon.edge(v, m_random.index(2)));
    else if((choice -= m_parameters.smoothing_rate) < 0)
      smooth(v);
    else
      shake(v);
  }

  bool remove(Index v)
  {
    const Index name = m_polygon.name(v);
    if(!m_polygon.remove(v)) return false;
    m_operations.push_back({Elementary_operation::REMOVE, name, 0, Vector::Zero()});
    if(m_polygon.number_of_edges() < m_best_of_attempt.edges) note_progress();
    if(m_polygon.number_of_free_nodes() == 0) m_is_exhausted = true;
    return true;
  }

  void insert(Index e)
  {
    const Index s = m_polygon.source(e), t = m_polygon.target(e);
    const Vector &a = m_polygon.position(s), &c = m_polygon.position(t);
    const Vector b = displaced((a + c) / 2);
    if(!is_acceptable((b - a).norm() + (b - c).norm() - (a - c).norm())) return;
    const Index first = m_polygon.name(s), second = m_polygon.name(t);
    if(m_polygon.insert(e, b))
      m_operations.push_back({Elementary_operation::INSERT, first, second, b});
  }

  // towards the middle of the neighbors
  void smooth(Index v)
  {
    const Vector& b = m_polygon.position(v);
    const Vector middle = (neighbor(v, 0) + neighbor(v, 1)) / 2;
    move(v, b + m_random.real() * (middle - b));
  }

  void shake(Index v)
  {
    const Vector &a = neighbor(v, 0), &b = m_polygon.position(v), &c = neighbor(v, 1);
    const Vector target = displaced(b);
    const double increase =
        (target - a).norm() - (b - a).norm() + (target - c).norm() - (b - c).norm();
    if(is_acceptable(increase)) move(v, target);
  }

  void move(Index v, const Vector& target)
  {
    if(m_polygon.move(v, target))
      m_operations.push_back({Elementary_operation::MOVE, m_polygon.name(v), 0, target});
  }

  const Vector& neighbor(Index v, std::size_t k) const
  {
    return m_polygon.position(m_polygon.neighbor(v, k));
  }

  // uniform in a cube, of a size that is small as often as large
  Vector displaced(const Vector& x)
  {
    double size = 2 * m_parameters.largest_step * m_mean_length;
    for(std::size_t k = m_random.index(m_parameters.number_of_step_sizes); k > 0; --k) size /= 2;
    const double dx = m_random.real(), dy = m_random.real(), dz = m_random.real();
    return x + size * Vector(dx - 0.5, dy - 0.5, dz - 0.5);
  }

  bool is_acceptable(double increase)
  {
    return increase <= 0 ||
           m_random.real() < decay(increase / (m_parameters.temperature * m_mean_length));
  }

  // exp(-x) but for a few per cent, the same on every platform
  static double decay(double x)
  {
    double y = 1 / (1 + x / 256);
    for(int k = 0; k < 8; ++k) y *= y; // to the power of 256
    return y;
  }

  // Removes all nodes that can be removed, in random order.
  void reduce()
  {
    std::vector<Index> order;
    for(bool has_changed = true; has_changed;) {
      has_changed = false;
      order.clear();
      for(std::size_t k = 0; k < m_polygon.number_of_free_nodes(); ++k)
        order.push_back(m_polygon.free_node(k));
      for(std::size_t k = order.size(); k > 1; --k)
        std::swap(order[k - 1], order[m_random.index(k)]);
      for(Index v : order) has_changed = remove(v) || has_changed;
    }
    m_polygon.renumber();
  }

  // A round has as many moves as there were edges at its start.
  void end_round()
  {
    ++m_rounds;
    if(m_rounds % rounds_between_renumbering == 0) m_polygon.renumber();
    if(m_moves - m_best_of_attempt.moves > m_parameters.patience(m_best_of_attempt.edges))
      give_up();
    else if(m_moves >= m_next_look)
      look_for_goal();
    measure();
  }

  void measure()
  {
    m_moves_until_end_of_round = m_polygon.number_of_edges();
    m_mean_length = m_polygon.length() / static_cast<double>(m_polygon.number_of_edges());
    m_polygon.keep_clear(m_parameters.clearance * m_mean_length);
  }

  void note_progress()
  {
    m_best_of_attempt = {m_polygon.number_of_edges(), m_operations.size(), m_moves};
    look_for_goal();
  }

  void look_for_goal()
  {
    m_next_look = m_moves + moves_between_looks;
    if(!m_goal(m_polygon)) return;
    m_has_reached_goal = true;
    m_best = m_polygon.number_of_edges();
    m_best_operations = m_operations;
  }

  // Ends an attempt, and the search after several in vain.
  void give_up()
  {
    m_attempts_in_vain = record() ? 0 : m_attempts_in_vain + 1;
    m_is_exhausted = m_attempts_in_vain >= m_parameters.max_attempts_in_vain;
    m_polygon = m_reduced;
    m_operations.resize(m_number_of_reductions);
    start_attempt();
  }

  void start_attempt()
  {
    m_best_of_attempt = {m_polygon.number_of_edges(), m_operations.size(), m_moves};
  }

  Tightening_parameters m_parameters;
  Tightening_goal m_goal;
  Random_source m_random;
  Tightening_polygon m_reduced, m_polygon;
  Operations m_operations, m_best_operations;
  std::size_t m_number_of_reductions = 0;
  Record m_best_of_attempt = {0, 0, 0};
  std::size_t m_best = static_cast<std::size_t>(-1);
  int m_attempts_in_vain = 0;
  std::size_t m_moves = 0, m_rounds = 0, m_moves_until_end_of_round = 0, m_next_look = 0;
  double m_mean_length = 0;
  bool m_has_reached_goal = false, m_is_exhausted = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_TIGHTENING_SEARCH_H
