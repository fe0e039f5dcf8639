// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "reports/report_rows.h"

#include "options/numbers.h"

#include <cmath>
#include <cstddef>

namespace vfc {
namespace {

std::string cell(const Report::Json& value)
{
  if(value.is_number_float() && std::isfinite(double(value))) return to_text(double(value));
  if(value.is_null() || value.is_number_float()) return "-";
  if(value.is_string()) return value;
  if(!value.is_array()) return value.dump();
  std::string text;
  for(const Report::Json& item : value)
    text += (text.empty() ? "" : " ") + (item.is_array() ? '[' + cell(item) + ']' : cell(item));
  return text;
}

} // namespace

std::string row(const std::string& key, const Report::Json& value)
{
  constexpr std::size_t width = 28;
  return key + std::string(width - key.size(), ' ') + cell(value) + '\n';
}

} // namespace vfc
