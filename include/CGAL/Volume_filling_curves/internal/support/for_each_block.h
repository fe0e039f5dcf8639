// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_FOR_EACH_BLOCK_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_FOR_EACH_BLOCK_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

#ifdef CGAL_LINKED_WITH_TBB
// Calls f(i) for each i < n in parallel. No template, so that TBB's scheduler compiles once per
// source: the runs of vfc take 164 s of CPU time to compile instead of 175.
inline void for_each_in_parallel(std::size_t n, const std::function<void(std::size_t)>& f)
{
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, n), [&](const Range& range) {
    for(std::size_t i = range.begin(); i != range.end(); ++i) f(i);
  });
}
#endif

// Loop that calls f(begin, end) for consecutive blocks of at most `block` indices that cover [0,
// n), in parallel with a parallel tag. The blocks only depend on n: results of f per index or per
// block are the same for any number of threads. Throws Run_stopped before a block if the run of the
// thread is to stop, see Watched_scope: f must leave nothing half done.
template <typename ConcurrencyTag, typename Function>
void for_each_block(std::size_t n, std::size_t block, const Function& f)
{
  constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
  Run_watch* const watch = Watched_scope::current();
  const auto run_block = [&](std::size_t b) {
    const Watched_scope scope(watch); // in whatever thread
    check_run();
    f(b * block, (std::min)(n, (b + 1) * block));
  };
  const std::size_t number_of_blocks = (n + block - 1) / block;
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(is_parallel)
    if(number_of_blocks > 1) return for_each_in_parallel(number_of_blocks, std::cref(run_block));
#else
  static_assert(!is_parallel, "Parallel_tag is enabled but TBB is unavailable.");
#endif
  for(std::size_t b = 0; b < number_of_blocks; ++b) run_block(b);
}

// The same under a watch, if there is one. \throws Run_stopped between two blocks
template <typename ConcurrencyTag, typename Function>
void for_each_block(std::size_t n, std::size_t block, Run_watch* watch, const Function& f)
{
  for_each_block<ConcurrencyTag>(n, block, [&](std::size_t begin, std::size_t end) {
    check(watch);
    f(begin, end);
  });
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
