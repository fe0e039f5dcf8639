// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_CPU_TIME_H
#define VFC_TEST_CPU_TIME_H

#include <algorithm>
#include <ctime>
#include <limits>

// CPU times of this process, for tests of ratios. Wall times depend on what else the machine does,
// and seconds on how fast it is.
namespace cpu_time {

// in seconds, so far
inline double of_process()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

template <typename Function>
double of(const Function& work)
{
  const double start = of_process();
  work();
  return of_process() - start;
}

// returns the CPU time of one work over that of another; the least of several turns counts
template <typename First, typename Second>
double ratio(const First& first, const Second& second)
{
  constexpr int turns = 3;
  double of_first = std::numeric_limits<double>::infinity(), of_second = of_first;
  for(int k = 0; k < turns; ++k) {
    of_first = (std::min)(of_first, of(first));
    of_second = (std::min)(of_second, of(second));
  }
  return of_first / of_second;
}

} // namespace cpu_time

#endif // VFC_TEST_CPU_TIME_H
