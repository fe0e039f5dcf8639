// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_GARBAGE_SCOPE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_GARBAGE_SCOPE_H

#include <CGAL/license/Volume_filling_curves.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Collects the garbage of a guarded curve at the end of its lifetime, also if a function of the
// caller, such as `progress`, ends a run by an exception: the caller's curve never keeps garbage.
template <typename Guard>
class Garbage_scope
{
public:
  explicit Garbage_scope(Guard& guard) : m_guard(guard) {}

  Garbage_scope(const Garbage_scope&) = delete;
  Garbage_scope& operator=(const Garbage_scope&) = delete;

  ~Garbage_scope()
  {
    if(m_guard.curve().has_garbage()) m_guard.collect_garbage();
  }

private:
  Guard& m_guard;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_GARBAGE_SCOPE_H
