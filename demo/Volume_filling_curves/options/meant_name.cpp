// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/meant_name.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace vfc {
namespace {

// The optimal string alignment distance, row by row.
std::size_t edit_distance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> before_last, last, row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for(std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last = row;
    row[0] = i;
    for(std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] != b[j - 1]);
      row[j] = (std::min)({last[j] + 1, row[j - 1] + 1, replaced});
      if(i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = (std::min)(row[j], before_last[j - 2] + 1);
    }
  }
  return row.back();
}

} // namespace

std::string meant_name(const std::string& typed, const std::vector<std::string>& names)
{
  std::string closest;
  std::size_t least = typed.size();
  for(const std::string& name : names) {
    const std::size_t distance = edit_distance(typed, name);
    if(3 * distance > name.size() || distance >= least) continue;
    least = distance;
    closest = name;
  }
  return closest;
}

} // namespace vfc
