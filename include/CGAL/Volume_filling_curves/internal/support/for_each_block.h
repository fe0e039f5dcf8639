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
#include <numeric>
#include <type_traits>
#include <vector>

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
    using Blocks = tbb::blocked_range<std::size_t>;
    const auto run = [&](const Blocks& blocks) {
      for(std::size_t b = blocks.begin(); b != blocks.end(); ++b)
        f(b * block, (std::min)(n, (b + 1) * block));
    };
    if(n > block) return tbb::parallel_for(Blocks(0, (n + block - 1) / block), run);
  }
#else
  static_assert(!is_parallel, "Parallel_tag is enabled but TBB is unavailable.");
#endif
  for(std::size_t begin = 0; begin < n; begin += block) f(begin, (std::min)(n, begin + block));
}

// Calls f(i) for each i < n, in parallel if asked to; for loops over nodes or edges that take some
// nanoseconds each.
template <typename ConcurrencyTag, typename Function>
void for_each_index(std::size_t n, const Function& f)
{
  constexpr std::size_t block = 1024;
  for_each_block<ConcurrencyTag>(n, block, [&](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i) f(i);
  });
}

// Returns the sum of f(i) over all i < n, added up block by block, and then the blocks: the same
// bits for every number of threads.
template <typename ConcurrencyTag, typename Function>
double sum_over_indices(std::size_t n, const Function& f)
{
  constexpr std::size_t block = 1024;
  std::vector<double> sums((n + block - 1) / block);
  for_each_block<ConcurrencyTag>(n, block, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for(std::size_t i = begin; i < end; ++i) sum += f(i);
    sums[begin / block] = sum;
  });
  return std::accumulate(sums.begin(), sums.end(), 0.);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_FOR_EACH_BLOCK_H
