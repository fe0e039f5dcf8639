// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "session/Thread_limit.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/info.h>
#endif

namespace vfc {

#ifdef CGAL_LINKED_WITH_TBB

Thread_limit::Thread_limit(std::size_t number)
    : m_number(number > 0 ? number : static_cast<std::size_t>(tbb::info::default_concurrency())),
      m_control(tbb::global_control::max_allowed_parallelism, m_number)
{}

#else

Thread_limit::Thread_limit(std::size_t) : m_number(1) {}

#endif

} // namespace vfc
