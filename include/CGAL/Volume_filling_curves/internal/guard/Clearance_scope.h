// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_CLEARANCE_SCOPE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_CLEARANCE_SCOPE_H

#include <CGAL/license/Volume_filling_curves.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Gives a guard another clearance for the life of this object: those who share a guard have
// clearances of their own.
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

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_CLEARANCE_SCOPE_H
