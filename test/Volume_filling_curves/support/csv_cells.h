// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_CSV_CELLS_H
#define VFC_TEST_CSV_CELLS_H

#include <string>
#include <vector>

// The cells of a line of a CSV file; cells in quotes may contain commas.
inline std::vector<std::string> csv_cells(const std::string& line)
{
  std::vector<std::string> result(1);
  bool is_quoted = false;
  for(const char c : line) {
    if(c == '"')
      is_quoted = !is_quoted;
    else if(c == ',' && !is_quoted)
      result.emplace_back();
    else
      result.back() += c;
  }
  return result;
}

#endif // VFC_TEST_CSV_CELLS_H
