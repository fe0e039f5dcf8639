// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_THREAD_LIMIT_H
#define VFC_THREAD_LIMIT_H

#include <cstddef>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

namespace vfc {

// Limits the number of threads as long as it exists; 0 stands for all.
class Thread_limit
{
public:
  explicit Thread_limit(std::size_t number);

  std::size_t number() const { return m_number; }

private:
  std::size_t m_number;
#ifdef CGAL_LINKED_WITH_TBB
  tbb::global_control m_control;
#endif
};

} // namespace vfc

#endif // VFC_THREAD_LIMIT_H
