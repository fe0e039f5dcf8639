// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_ROPELENGTH_ROPELENGTH_DESCENT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_ROPELENGTH_ROPELENGTH_DESCENT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/ropelength/Rollback.h>
#include <CGAL/Volume_filling_curves/internal/ropelength/Rope.h>
#include <CGAL/Volume_filling_curves/internal/ropelength/Rope_contacts.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Descent of the ropelength of closed curves: a rope of constant radius is pulled tight, and yields
// where it overlaps or kinks (after Pieranski 1998, shrinking on no overlaps). It starts with long
// edges, until the length hardly falls, and continues with edges half as long, until these are
// short; finally the tension fades, which lets overlaps come apart.
//
// The descent uses floating point arithmetic. Whenever a node has moved by a tenth of the diameter,
// and every few iterations, the guard moves the curve along, straight and certified, by too short a
// distance for strands a diameter apart to meet. The rope takes refused motions back. The result is
// the curve of least measured ropelength during the descent, including its start. An iteration
// takes linear time, 0.1 ms for 200 nodes; there are one to five thousand.
template <typename Guard, typename ConcurrencyTag>
class Ropelength_descent
{
public:
  // The radius is that of the rope, half of the distance that strands are to keep.
  // \pre all components are closed, no node is pinned, and there is no garbage
  Ropelength_descent(Guard& guard, double radius)
      : m_guard(guard), m_radius(radius), m_rollback(guard), m_rope(guard.curve(), radius)
  {}

  // Calls go_on() after each certified motion, and stops if it returns false, or if the guard's
  // watch, checked in each iteration, requests it. Returns whether the descent was completed.
  template <typename Function>
  bool operator()(const Function& go_on)
  {
    bool is_complete = false;
    try {
      is_complete = tighten(go_on);
    } catch(const Run_stopped&) { // the curve is where a motion was certified last
      m_is_stopped = true;
    }
    return m_rollback.return_to_min_ropelength() && is_complete;
  }

  // whether it was the watch that ended it
  bool is_stopped() const { return m_is_stopped; }

private:
  // The mean, at most, in radii. Around the tightest bend, edges of 0.7 are 4 % longer than the
  // arc, and edges of 0.3 are 0.7 % longer, but take more time.
  static constexpr double coarse_edge = 0.7, fine_edge = 0.3;
  // A pull of 1/2 would move nodes to the middle between their neighbors. The weaker the pull, the
  // less it presses the rope together; the weakest is reached in four blocks.
  static constexpr double strongest_pull = 0.25, weakest_pull = 0.0125, weakening = 0.985;
  static constexpr int block = 50; // iterations
  static constexpr int max_blocks = 100;
  static constexpr double noticeable = 1e-4; // a fall of the length in a block
  static constexpr double helpful = 1e-3;    // a fall that is worth continuing

  // All steps below return whether to continue.

  template <typename Function>
  bool tighten(const Function& go_on)
  {
    while(m_rope.mean_edge() > coarse_edge)
      if(!halve_edges() || !go_on()) return false;
    take_up();
    if(!find_minimum(go_on)) return false;
    while(m_rope.mean_edge() > fine_edge)
      if(!halve_edges() || !contract(go_on)) return false;
    return relax(go_on) && come_to_rest(go_on);
  }

  bool halve_edges()
  {
    const bool is_done = m_rollback.halve_edges();
    m_rope = Rope(m_guard.curve(), m_radius);
    take_up();
    return is_done;
  }

  // Pulls with long edges. Symmetric curves get stuck where a less symmetric one would be shorter:
  // the Borromean rings, as the closure of a braid, at a ropelength of 72 instead of 58, the torus
  // knot of type (2, 7) at 64 instead of 61.6 (2026-11-22). So the rope is distorted and pulled
  // again, as long as this helps.
  template <typename Function>
  bool find_minimum(const Function& go_on)
  {
    constexpr int max_distortions = 30, max_failures = 3; // in a row
    if(!contract(go_on)) return false;
    double least = m_rope.length();
    for(int k = 0, in_vain = 0; k < max_distortions && in_vain < max_failures; ++k) {
      distort();
      if(!contract(go_on)) return false;
      const bool has_helped = m_rope.length() < (1 - helpful) * least;
      in_vain = has_helped ? 0 : in_vain + 1;
      if(has_helped) least = m_rope.length();
    }
    return true;
  }

  // Distortion by a linear map close to the identity, along which no strands meet.
  void distort()
  {
    constexpr double strength = 0.05; // 0.02 frees the knots above more slowly
    Vector center;
    for(const Vector& p : m_rope.x) center += p / static_cast<double>(m_rope.size());
    std::array<Vector, 3> columns;
    for(Vector& column : columns)
      for(int k = 0; k < 3; ++k) column[k] = strength * (2 * m_random.real() - 1);
    for(Vector& p : m_rope.x) {
      const Vector d = p - center;
      p += d.x() * columns[0] + d.y() * columns[1] + d.z() * columns[2];
    }
  }

  // Pulls until the length hardly falls.
  template <typename Function>
  bool contract(const Function& go_on)
  {
    for(int k = 0; k < max_blocks; ++k) {
      const double before = m_rope.length();
      if(!make_block(strongest_pull, go_on)) return false;
      if(m_rope.length() > (1 - noticeable) * before) break;
    }
    return true;
  }

  template <typename Function>
  bool relax(const Function& go_on)
  {
    double weakening_of_block = 1;
    for(int k = 0; k < block; ++k) weakening_of_block *= weakening;
    for(double strength = strongest_pull; strength > weakest_pull; strength *= weakening_of_block)
      if(!make_block(strength, go_on, weakening)) return false;
    return true;
  }

  // Long bends that are as tight as they may be take their time; it may be too long.
  template <typename Function>
  bool come_to_rest(const Function& go_on)
  {
    for(int k = 0; k < max_blocks; ++k) {
      const double before = m_rollback.min_ropelength();
      if(!make_block(weakest_pull, go_on)) return false;
      if(m_rollback.min_ropelength() > (1 - helpful) * before) return true;
    }
    return false;
  }

  // Iterates with a tension that fades by a factor each time, and makes the remaining motion.
  template <typename Function>
  bool make_block(double strength, const Function& go_on, double fading = 1)
  {
    for(int i = 0; i < block; ++i, strength *= fading)
      if(!iterate(strength, go_on)) return false;
    return carry_out(go_on);
  }

  template <typename Function>
  bool iterate(double strength, const Function& go_on)
  {
    check_time();
    pull(m_rope, strength, m_workspace);
    m_contacts.push_apart(m_rope);
    straighten(m_rope);
    return !has_moved_far() || carry_out(go_on);
  }

  // The motion back needs its share of the time.
  void check_time() const
  {
    Run_watch* const watch = m_guard.watch();
    if(watch == nullptr) return;
    watch->check();
    if(watch->is_interrupted() || !watch->leaves(m_rollback.seconds_back())) throw Run_stopped();
  }

  bool has_moved_far() const
  {
    constexpr double far = Rope_contacts::slack;
    for(std::size_t v = 0; v < m_rope.size(); ++v)
      if((m_rope.x[v] - m_certified[v]).squaredNorm() > far * far) return true;
    return false;
  }

  // Returns whether to continue from there.
  template <typename Function>
  bool carry_out(const Function& go_on)
  {
    const double fraction = m_rollback.move(m_rope.coordinates(m_radius));
    m_rollback.note();
    m_rope.take_positions(m_guard.curve(), m_radius);
    take_up();
    return fraction > 0 && go_on();
  }

  void take_up()
  {
    m_certified = m_rope.x;
    m_contacts.find(m_rope);
  }

  Guard& m_guard;
  double m_radius;
  Rollback<Guard, ConcurrencyTag> m_rollback;
  Rope m_rope;
  Rope_contacts m_contacts;
  std::vector<Vector> m_certified; // where the curve is
  std::vector<Vector> m_workspace;
  Random_source m_random{0}; // the distortions are the same in each run
  bool m_is_stopped = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_ROPELENGTH_ROPELENGTH_DESCENT_H
