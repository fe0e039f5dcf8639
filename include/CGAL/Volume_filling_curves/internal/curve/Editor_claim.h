// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_EDITOR_CLAIM_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_EDITOR_CLAIM_H

#include <CGAL/license/Volume_filling_curves.h>

#include <stdexcept>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Claim of the only editor of a network. The observers of one editor would miss the changes of
// another, and a guard would certify changes of an outdated curve. A copy of a network has no
// editor, and an assigned network keeps its own.
class Editor_claim
{
public:
  Editor_claim() = default;
  Editor_claim(const Editor_claim&) {}
  Editor_claim& operator=(const Editor_claim&) { return *this; }

  // Throws std::logic_error if there is an editor already.
  void take()
  {
    if(m_is_taken) throw std::logic_error("the network has another guard, or is being changed");
    m_is_taken = true;
  }

  void give_back() { m_is_taken = false; }

private:
  bool m_is_taken = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_EDITOR_CLAIM_H
