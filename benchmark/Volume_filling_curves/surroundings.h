// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_BENCHMARK_SURROUNDINGS_H
#define VFC_BENCHMARK_SURROUNDINGS_H

#include <CGAL/Volume_filling_curves/internal/vocabulary/version.h>

#include <CGAL/version.h>
#include <boost/config.hpp>

#include <ctime>
#include <fstream>
#include <string>

#include "Json_line.h"

namespace vfc_benchmark {

// CPU seconds of all threads of the process
inline double cpu_seconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// the processor's name, if the system reports it
inline std::string machine()
{
  std::ifstream info("/proc/cpuinfo");
  for(std::string line; std::getline(info, line);)
    if(line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  return "unknown";
}

// what a figure depends on besides the program
inline void add_surroundings(Json_line& line)
{
  line.add("version", CGAL_VOLUME_FILLING_CURVES_VERSION)
      .add("cgal", CGAL_VERSION_STR)
      .add("compiler", BOOST_COMPILER)
      .add("machine", machine());
}

} // namespace vfc_benchmark

#endif // VFC_BENCHMARK_SURROUNDINGS_H
