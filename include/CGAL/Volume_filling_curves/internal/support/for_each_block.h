// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_FOR_EACH_BLOCK_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_FOR_EACH_BLOCK_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Calls f(begin, end) for consecutive blocks of at most `block` indices that cover [0, n), in
// parallel if asked to. The blocks depend on n only, so that whatever f writes per index or per
// block is the same for every number of threads.
template <typename ConcurrencyTag, typename Function>
void for_each_block(std::size_t n, std::size_t block, const Function& f)
{
  constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(is_parallel) {
    const auto run = [&](const tbb::blocked_range<std::size_t>& blocks) {
      for(std::size_t b = blocks.begin(); b != blocks.end(); ++b)
        f(b * block, (std::min)(n, (b + 1) * block));
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, (n + block - 1) / block), run);
    return;
  }
#else
  static_assert(!is_parallel, "Parallel_tag is enabled but TBB is unavailable.");
#endif
  for(std::size_t begin = 0; begin < n; begin += block) f(begin, (std::min)(n, begin + block));
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_FOR_EACH_BLOCK_H
