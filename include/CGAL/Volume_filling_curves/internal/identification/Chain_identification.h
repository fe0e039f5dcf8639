// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_IDENTIFICATION_CHAIN_IDENTIFICATION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_IDENTIFICATION_CHAIN_IDENTIFICATION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Link_identification.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/diagram_of_curve.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/simplified_diagram.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/identification/chain_closures.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Chain_identity.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The knots that an open chain forms when it is closed, and those of its sections. An open chain
// has no knot type: each closure has, and their frequencies over all directions to infinity
// describe the chain (Millett, Dobay, Stasiak 2005). With a parallel tag, the closures of a
// section are found in parallel.
template <typename ConcurrencyTag>
class Chain_identification
{
public:
  // \pre the chain has at least two points
  Chain_identification(std::vector<Vector> chain,
                       const Chain_parameters& parameters,
                       Run_watch& watch)
      : m_chain(std::move(chain)),
        m_parameters(parameters),
        m_directions(spread_directions(parameters.closures, parameters.random_seed)),
        m_watch(watch)
  {}

  // \throws std::invalid_argument if the chain meets itself
  // \throws Run_stopped in a Watched_scope
  Chain_identity operator()()
  {
    Chain_identity identity;
    identity.knots = knots(0, m_chain.size() - 1);
    identity.name = identity.knots.front().name;
    identity.direct = knot(closed_polygon(m_chain));
    identity.least_interfering = knot(minimally_interfering_closure(m_chain));
    const bool has_knot = !identity.name.empty() && identity.name != "0_1";
    if(m_parameters.find_core && has_knot) identity.core = {core(identity.name)};
    if(m_parameters.stride > 0) find_fingerprint(identity);
    return identity;
  }

private:
  using Crossings = std::vector<std::array<std::uint32_t, 4>>;

  // The knots of a section closed at infinity, see Chain_identity::knots.
  std::vector<Knot_share> knots(std::size_t first, std::size_t last)
  {
    std::vector<Closure_knot> closures(m_directions.size());
    for_each_block<ConcurrencyTag>(closures.size(), 1, [&](std::size_t i, std::size_t) {
      closures[i] = knot(first, last, m_directions[i]);
    });
    std::map<std::string, Knot_share> by_name;
    for(const Closure_knot& found : closures) {
      Knot_share& share =
          by_name.try_emplace(found.name, Knot_share{found.name, true}).first->second;
      share.is_proved &= found.is_proved;
      ++share.count;
    }
    std::vector<Knot_share> shares;
    const auto n = static_cast<double>(m_directions.size());
    for(auto& [name, knot] : by_name) {
      knot.share = static_cast<double>(knot.count) / n;
      knot.standard_error = std::sqrt(knot.share * (1 - knot.share) / n);
      shares.push_back(std::move(knot));
    }
    std::stable_sort(shares.begin(), shares.end(),
                     [](const Knot_share& a, const Knot_share& b) { return a.count > b.count; });
    return shares;
  }

  Closure_knot knot(std::size_t first, std::size_t last, const Viewing_direction& direction)
  {
    const auto begin = m_chain.begin();
    std::vector<Vector> section(begin + std::ptrdiff_t(first), begin + std::ptrdiff_t(last) + 1);
    return knot(diagram_closed_at_infinity(std::move(section), direction));
  }

  Closure_knot knot(const Closed_polygons& polygon)
  {
    constexpr std::size_t number_of_directions = 20;
    const auto diagram = find_diagram(polygon, number_of_directions);
    return diagram ? knot(*diagram) : Closure_knot();
  }

  // Diagrams repeat themselves: those of one knot that have few crossings are few. Two threads that
  // meet a new one at the same time both find the same knot.
  Closure_knot knot(const Planar_diagram& diagram)
  {
    Planar_diagram simplified = simplified_diagram(diagram);
    const Crossings crossings = simplified.crossings;
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      const auto known = m_known.find(crossings);
      if(known != m_known.end()) return known->second;
    }
    const Link_identity identity = Link_identification(std::move(simplified))();
    const std::lock_guard<std::mutex> lock(m_mutex);
    return m_known.try_emplace(crossings, Closure_knot{identity.name, identity.is_proved})
        .first->second;
  }

  // The section and its most frequent knot.
  Chain_section section(std::size_t first, std::size_t last)
  {
    const Knot_share knot = knots(first, last).front();
    return {first, last, knot.name, knot.share};
  }

  // The core, by trimming both ends as KymoKnot does (Tubiana et al. 2018), which of them first
  // whatever gives the shorter one.
  Chain_section core(const std::string& name)
  {
    const Chain_section whole{0, m_chain.size() - 1, name, 0};
    const Chain_section one = trimmed(whole, true), other = trimmed(whole, false);
    return one.last - one.first <= other.last - other.first ? one : other;
  }

  // Removes nodes at both ends in turn while the knot stays.
  Chain_section trimmed(Chain_section core, bool is_first)
  {
    for(std::size_t length = 0; length != core.last - core.first;) {
      length = core.last - core.first;
      core = trimmed_at_one_end(trimmed_at_one_end(core, is_first), !is_first);
    }
    return core;
  }

  // Steps are halved down to a single node: hence about 2 log n sections per end instead of n.
  Chain_section trimmed_at_one_end(Chain_section core, bool is_first)
  {
    for(std::size_t step = (core.last - core.first) / 2; step > 0;) {
      if(step < core.last - core.first) {
        const Chain_section shorter = is_first ? section(core.first + step, core.last)
                                               : section(core.first, core.last - step);
        if(shorter.name == core.name) {
          core = shorter;
          continue;
        }
      }
      step /= 2;
    }
    return core;
  }

  void find_fingerprint(Chain_identity& identity)
  {
    std::vector<std::size_t> nodes;
    const std::size_t last = m_chain.size() - 1, stride = (std::min)(m_parameters.stride, last);
    for(std::size_t v = 0; v < last; v += stride) nodes.push_back(v);
    nodes.push_back(last);
    const std::size_t number = nodes.size() * (nodes.size() - 1) / 2;
    m_watch.begin(Run_stage::MEASURING);
    for(std::size_t i = 0; i < nodes.size(); ++i)
      for(std::size_t k = i + 1; k < nodes.size(); ++k) {
        m_watch.note_fraction(double(identity.fingerprint.size()) / double(number));
        identity.fingerprint.push_back(section(nodes[i], nodes[k]));
        note_slipknot(identity.fingerprint.back(), identity);
      }
  }

  static void note_slipknot(const Chain_section& section, Chain_identity& identity)
  {
    const std::string& name = section.name;
    if(name.empty() || name == "0_1" || name == identity.name || section.share <= 0.5) return;
    const auto known =
        std::find_if(identity.slipknots.begin(), identity.slipknots.end(),
                     [&](const Chain_section& slipknot) { return slipknot.name == name; });
    if(known == identity.slipknots.end())
      identity.slipknots.push_back(section);
    else if(section.last - section.first < known->last - known->first)
      *known = section;
  }

  const std::vector<Vector> m_chain;
  const Chain_parameters m_parameters;
  const std::vector<Viewing_direction> m_directions;
  std::map<Crossings, Closure_knot> m_known; // by diagrams
  std::mutex m_mutex;                        // of known diagrams
  Run_watch& m_watch;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_IDENTIFICATION_CHAIN_IDENTIFICATION_H
