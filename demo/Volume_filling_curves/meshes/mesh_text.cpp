// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/mesh_text.h"

#include <algorithm>

namespace vfc {

std::string in_quotes(std::string_view text)
{
  constexpr std::size_t max_length = 40;
  std::string part(text.substr(0, max_length));
  for(char& c : part)
    if(c < 0x20 || c > 0x7e) c = '?';
  return "'" + part + (text.size() > max_length ? "...'" : "'");
}

std::size_t line_at(std::string_view text, std::size_t place)
{
  const std::string_view before = text.substr(0, place);
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

} // namespace vfc
