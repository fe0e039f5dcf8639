// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_STRAND_REROUTING_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_STRAND_REROUTING_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Editable_diagram.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Rerouting of a strand that passes above, or below, all other strands, to a shortest path through
// the faces from its start to its end. Reidemeister's moves are the simplest cases; long strands
// move far at once. (The simplifications of SnapPy, and of Knoodle, Cantarella and Schumacher 2025,
// use the same move.) Each search only visits faces within the length of the strand.
class Strand_rerouting
{
  using Slot = Editable_diagram::Slot;
  static constexpr Slot none = Editable_diagram::none;

public:
  explicit Strand_rerouting(Editable_diagram& diagram) : m_diagram(diagram) {}

  // The work so far: the arcs that the searches for paths saw along faces.
  std::size_t number_of_seen_arcs() const { return m_number_of_seen_arcs; }

  // Moves a strand to a path with fewer crossings, and returns whether there was one. The strand
  // leaves from a slot and ends before its level changes, or after `max_length` crossings.
  bool shorten(Slot start, std::size_t max_length)
  {
    return take_strand(start, max_length) && find_path(m_crossings.size() - 1, nullptr) && move();
  }

  // Moves a strand to a random one of the shortest other paths, with no more crossings.
  // Returns whether it was moved.
  bool move_at_random(Slot start, std::size_t max_length, Random_source& random)
  {
    return take_strand(start, max_length) && find_path(m_crossings.size(), &random) && move();
  }

  // Removes the component of a slot from all its crossings if it passes above, or below, all
  // others. Returns whether it does.
  bool lift_component(Slot start)
  {
    const bool is_over = Editable_diagram::is_over(start);
    Slot s = start;
    do {
      s = Editable_diagram::across(m_diagram.mate(s));
      if(Editable_diagram::is_over(s) != is_over) return false;
    } while(s != start);
    m_crossings.clear();
    do {
      m_crossings.push_back(s);
      s = Editable_diagram::across(m_diagram.mate(s));
    } while(s != start);
    for(const Slot c : m_crossings) m_diagram.remove_crossing(c);
    m_diagram.add_free_loop();
    return true;
  }

private:
  // A face of the path, and the arc crossed on entering it, as its slot on the side of the face
  // before.
  struct Face
  {
    std::size_t before;
    Slot crossed; // none if it is the same face without the strand
  };
  struct Step
  {
    Slot into; // on the left of which the face lies
    Face face;
  };

  // Collects the slots at which the strand leaves its crossings; returns whether there are any.
  bool take_strand(Slot start, std::size_t max_length)
  {
    m_start = start;
    m_crossings.clear();
    Slot s = m_diagram.mate(start);
    m_is_over = Editable_diagram::is_over(s);
    while(Editable_diagram::is_over(s) == m_is_over && m_crossings.size() < max_length &&
          Editable_diagram::across(s) != start) {
      m_crossings.push_back(Editable_diagram::across(s));
      s = m_diagram.mate(m_crossings.back());
    }
    m_end = s;
    return !m_crossings.empty();
  }

  // Breadth-first search over the faces of the diagram without the strand.
  bool find_path(std::size_t max_length, Random_source* random)
  {
    begin_search();
    m_current.assign({{m_start, {0, none}}});
    for(std::size_t length = 0; length <= max_length && !m_current.empty(); ++length) {
      m_next.clear();
      while(!m_current.empty()) {
        const Step step = m_current.back();
        m_current.pop_back();
        if(m_stamps[step.into] != m_stamp && visit(step)) return true;
      }
      std::swap(m_current, m_next);
      if(random != nullptr) shuffle(m_current, *random);
    }
    return false;
  }

  void begin_search()
  {
    m_faces.clear();
    m_stamps.resize(m_diagram.number_of_slots(), 0);
    m_strand_stamps.resize(m_stamps.size(), 0);
    ++m_stamp;
    mark_strand(m_start);
    for(const Slot s : m_crossings) mark_strand(s);
  }

  void mark_strand(Slot s) { m_strand_stamps[s] = m_strand_stamps[m_diagram.mate(s)] = m_stamp; }

  // Visits a face; returns whether the strand ends there.
  bool visit(const Step& step)
  {
    const std::size_t face = m_faces.size();
    m_faces.push_back(step.face);
    bool is_end = false;
    Slot s = step.into;
    do {
      ++m_number_of_seen_arcs;
      m_stamps[s] = m_stamp;
      const Slot other = m_diagram.mate(s);
      is_end = is_end || s == m_end || other == m_end;
      if(m_stamps[other] != m_stamp) {
        if(m_strand_stamps[s] == m_stamp)
          m_current.push_back({other, {face, none}});
        else
          m_next.push_back({other, {face, s}});
      }
      s = m_diagram.next_around_face(s);
    } while(s != step.into);
    return is_end;
  }

  static void shuffle(std::vector<Step>& steps, Random_source& random)
  {
    for(std::size_t k = steps.size(); k > 1; --k) std::swap(steps[k - 1], steps[random.index(k)]);
  }

  // Moves the strand to the path that was found.
  bool move()
  {
    std::vector<Slot>& path = m_path;
    path.clear();
    for(std::size_t f = m_faces.size() - 1; f != 0; f = m_faces[f].before)
      if(m_faces[f].crossed != none) path.push_back(m_faces[f].crossed);
    Slot from = m_start;
    for(auto arc = path.rbegin(); arc != path.rend(); ++arc) {
      const Slot arrival = m_diagram.insert_crossing(*arc, m_is_over);
      m_diagram.join(from, arrival);
      from = Editable_diagram::across(arrival);
    }
    m_diagram.join(from, m_end);
    for(const Slot s : m_crossings) m_diagram.remove_crossing(s);
    return true;
  }

  Editable_diagram& m_diagram;
  Slot m_start = none, m_end = none;
  bool m_is_over = false;
  std::vector<Slot> m_crossings, m_path;
  std::vector<Face> m_faces;
  std::vector<Step> m_current, m_next;
  std::vector<std::uint32_t> m_stamps, m_strand_stamps; // of the search that saw a slot last
  std::uint32_t m_stamp = 0;
  std::size_t m_number_of_seen_arcs = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_STRAND_REROUTING_H
