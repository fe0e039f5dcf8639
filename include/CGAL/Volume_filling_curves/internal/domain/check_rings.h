// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_CHECK_RINGS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_CHECK_RINGS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Ring_tree.h>
#include <CGAL/Volume_filling_curves/internal/domain/mesh_faults.h>
#include <CGAL/Volume_filling_curves/internal/geometry/planar_predicates.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <cmath>
#include <cstddef>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Check of the rings of a region. Corners, holes and polygons are numbered from 0, in their order
// in the input. Near-linear in the number of edges.
class Ring_check
{
public:
  explicit Ring_check(const std::vector<Ring>& rings) : m_rings(rings) {}

  // Checks rings one by one. \throws std::invalid_argument if one bounds no area
  void check_each() const
  {
    if(m_rings.empty()) throw std::invalid_argument("no geometry: there are no polygons");
    for(const Ring& ring : m_rings) {
      for(std::size_t k = 0; k < ring.corners.size(); ++k) check_corner(ring, k);
      if(ring.corners.size() < 3)
        throw std::invalid_argument("degenerate ring: " + name(ring) +
                                    " has fewer than 3 different corners");
    }
  }

  // Checks them together. \pre check_each() has not thrown
  // \throws std::invalid_argument if edges meet elsewhere than in a common corner, or if the
  // nesting of rings is not that of polygons and holes
  void check_all(const Ring_tree& tree) const
  {
    for(const Ring_tree::Edge& edge : tree.edges()) {
      check_run();
      check_edge(edge, tree);
    }
    for(std::size_t r = 0; r < m_rings.size(); ++r) check_nesting(r, tree);
  }

private:
  using Edge = Ring_tree::Edge;

  void check_corner(const Ring& ring, std::size_t k) const
  {
    for(const double x : {ring.corners[k].x(), ring.corners[k].y()}) {
      if(!std::isfinite(x))
        throw std::invalid_argument("non-finite coordinate: corner " +
                                    std::to_string(ring.numbers[k]) + " of " + name(ring));
      if(std::abs(x) > max_mesh_coordinate)
        throw std::invalid_argument("coordinate too large: corner " +
                                    std::to_string(ring.numbers[k]) + " of " + name(ring) +
                                    " is beyond 1e100");
    }
  }

  void check_edge(const Edge& edge, const Ring_tree& tree) const
  {
    tree.any_meeting({edge.source, edge.target, edge.target}, [&](const Edge& other) {
      if(do_cross(edge, other)) refuse_pair(edge, other);
      return false;
    });
  }

  // Whether two edges that meet have another common point than the corner between them.
  bool do_cross(const Edge& e, const Edge& f) const
  {
    const std::size_t n = m_rings[e.ring].corners.size();
    if(e.ring != f.ring) return true;
    if(e.number == f.number) return false;
    if((e.number + 1) % n == f.number) return does_fold(e, f);
    return (f.number + 1) % n == e.number ? does_fold(f, e) : true;
  }

  static bool does_fold(const Edge& e, const Edge& next)
  {
    return does_segment_hold(e.source, e.target, next.target) ||
           does_segment_hold(next.source, next.target, e.source);
  }

  // An outer boundary lies in an even number of rings. A hole lies in an odd number of them, of its
  // own polygon only in the outer boundary, which comes before the holes.
  void check_nesting(std::size_t r, const Ring_tree& tree) const
  {
    const Ring& ring = m_rings[r];
    std::vector<std::size_t> own;
    bool is_odd = false;
    for(const std::size_t q : tree.rings_around(ring.corners[0], r)) {
      is_odd = !is_odd;
      if(m_rings[q].polygon == ring.polygon) own.push_back(q);
    }
    if(ring.is_outer()) {
      if(is_odd) throw std::invalid_argument("overlap: " + name(ring) + " lies within a polygon");
      return;
    }
    if(own.empty() || !m_rings[own.front()].is_outer())
      throw std::invalid_argument("misplaced hole: " + name(ring) + " lies outside of its polygon");
    if(!is_odd || own.size() > 1)
      throw std::invalid_argument("misplaced hole: " + name(ring) +
                                  " lies within another hole or polygon");
  }

  [[noreturn]] void refuse_pair(const Edge& e, const Edge& f) const
  {
    throw std::invalid_argument("self-contact: " + text(e) + " meets " + text(f));
  }

  std::string text(const Edge& e) const
  {
    const Ring& ring = m_rings[e.ring];
    const std::size_t next = (e.number + 1) % ring.corners.size();
    return "the edge of corners " + std::to_string(ring.numbers[e.number]) + " and " +
           std::to_string(ring.numbers[next]) + " of " + name(ring) + " at " + text(e.source);
  }

  static std::string text(const Planar_point& p)
  {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << '(' << p.x() << ", " << p.y() << ')';
    return text.str();
  }

  static std::string name(const Ring& ring)
  {
    return (ring.is_outer() ? "the outer boundary" : "hole " + std::to_string(ring.hole)) +
           " of polygon " + std::to_string(ring.polygon);
  }

  const std::vector<Ring>& m_rings;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_CHECK_RINGS_H
