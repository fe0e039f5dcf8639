// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/lists.h"

namespace vfc {

std::vector<std::string> items_of_list(const std::string& list)
{
  std::vector<std::string> items(1);
  for(const char c : list)
    if(c == ',')
      items.emplace_back();
    else
      items.back() += c;
  return items;
}

std::size_t find_comma(const std::string& text, int n)
{
  std::size_t k = text.find(',');
  while(--n > 0 && k != std::string::npos) k = text.find(',', k + 1);
  return k;
}

} // namespace vfc
