// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_CLEARANCE_RULE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_CLEARANCE_RULE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Clearance rule: edges without a common node stay at least `distance` apart, or at least half as
// far as they were; edges with a common node keep their opening in the same way. A valid change
// could otherwise end so close to contact that nothing near it can move again (Goeritz' unknot,
// strands 1e-13 apart). The rule is not part of the proof of isotopy, only keeps the flow moving,
// and is decided in double arithmetic.
class Clearance_rule
{
public:
  Clearance_rule() = default;
  explicit Clearance_rule(double distance) : m_distance((std::max)(0., distance)) {} // 0 for NaN

  double distance() const { return m_distance; }
  bool is_active() const { return m_distance > 0; }

  // Returns whether edges may be as close as `after`, given their former distance `before()`.
  template <typename SquaredDistance>
  bool allows_distance(double squared_after, const SquaredDistance& squared_before) const
  {
    return squared_after >= m_distance * m_distance ||
           squared_after >= kept_fraction * kept_fraction * squared_before();
  }

  template <typename Opening>
  bool allows_opening(double after, const Opening& before) const
  {
    return !is_active() || after >= safe_opening || after >= kept_fraction * before();
  }

  // The opening of the corner abc: the distance of the points at distance 1 from b towards a and c,
  // 2 if straight and 0 if folded.
  static double opening(const Vector& a, const Vector& b, const Vector& c)
  {
    return ((a - b).normalized() - (c - b).normalized()).norm();
  }

private:
  // Larger fractions refuse more steps. With a half, strands need 44 steps in a row to come as
  // close as 1e-13 of their distance.
  static constexpr double kept_fraction = 0.5;
  // An opening of 20 degrees. Only sharper corners, which are about to fold, are protected.
  static constexpr double safe_opening = 0.35;

  double m_distance = 0;
};

// Sets another clearance of a guard during the lifetime of this object: the users of a guard have
// their own clearances.
template <typename Guard>
class Clearance_scope
{
public:
  Clearance_scope(Guard& guard, double clearance) : m_guard(guard), m_former(guard.clearance())
  {
    guard.set_clearance(clearance);
  }

  Clearance_scope(const Clearance_scope&) = delete;
  Clearance_scope& operator=(const Clearance_scope&) = delete;
  ~Clearance_scope() { m_guard.set_clearance(m_former); }

private:
  Guard& m_guard;
  double m_former;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_CLEARANCE_RULE_H
