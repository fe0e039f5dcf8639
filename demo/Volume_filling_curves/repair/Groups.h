// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_REPAIR_GROUPS_H
#define VFC_REPAIR_GROUPS_H

#include <CGAL/Union_find.h>

#include <cstddef>
#include <vector>

namespace vfc {

// The numbers below n in groups, at first each on its own.
class Groups
{
public:
  explicit Groups(std::size_t n)
  {
    for(std::size_t i = 0; i < n; ++i) m_handles.push_back(m_sets.make_set(i));
  }

  void unite(std::size_t i, std::size_t j) { m_sets.unify_sets(m_handles[i], m_handles[j]); }

  // Returns the representative of the group of i.
  std::size_t of(std::size_t i) const { return *m_sets.find(m_handles[i]); }

private:
  CGAL::Union_find<std::size_t> m_sets;
  std::vector<CGAL::Union_find<std::size_t>::handle> m_handles;
};

} // namespace vfc

#endif // VFC_REPAIR_GROUPS_H
