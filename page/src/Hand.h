// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_HAND_H
#define VFC_HAND_H

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vfc_page {

// The node that a user holds. It is pinned, so that neither flow nor remeshing takes it away, and
// followed when nodes are renumbered.
class Hand final : public CGAL::Volume_filling_curves::Curve_network_observer_3<>
{
  using Curve = CGAL::Volume_filling_curves::Curve_network_3<>;
  using Guard = CGAL::Volume_filling_curves::Isotopy_guard_3<>;

public:
  std::size_t node() const { return m_node; } // or Curve::null_node()
  bool is_empty() const { return m_node == Curve::null_node(); }

  void hold(Guard& guard, std::size_t v)
  {
    release(guard);
    m_node = v;
    m_was_pinned = guard.curve().is_pinned(v);
    guard.set_pinned(v);
    guard.add_observer(*this);
  }

  void release(Guard& guard)
  {
    if(is_empty()) return;
    guard.remove_observer(*this);
    guard.set_pinned(m_node, m_was_pinned);
    m_node = Curve::null_node();
  }

  // The guard's curve, with the pin that it has without a hand.
  Curve released(Curve curve) const
  {
    if(!is_empty()) curve.set_pinned(m_node, m_was_pinned);
    return curve;
  }

  void on_renumbering(const std::vector<std::uint32_t>& former) override
  {
    const auto place = std::find(former.begin(), former.end(), m_node);
    m_node = static_cast<std::size_t>(place - former.begin());
  }

private:
  std::size_t m_node = Curve::null_node();
  bool m_was_pinned = false;
};

} // namespace vfc_page

#endif // VFC_HAND_H
