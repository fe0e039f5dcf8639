// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "reports/resources.h"

#ifndef _WIN32
#include <sys/resource.h>
#else
#include <ctime>
#endif

namespace vfc {

#ifndef _WIN32

namespace {

rusage usage()
{
  rusage result{};
  getrusage(RUSAGE_SELF, &result);
  return result;
}

double seconds(const timeval& time)
{
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

} // namespace

double cpu_seconds()
{
  const rusage used = usage();
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

std::size_t peak_memory_bytes()
{
#ifdef __APPLE__
  constexpr std::size_t unit = 1;
#else
  constexpr std::size_t unit = 1024;
#endif
  return unit * static_cast<std::size_t>(usage().ru_maxrss);
}

#else

double cpu_seconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::size_t peak_memory_bytes()
{
  return 0;
}

#endif

} // namespace vfc
