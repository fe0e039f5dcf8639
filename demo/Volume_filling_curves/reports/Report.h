// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_REPORT_H
#define VFC_REPORT_H

#include <nlohmann/json.hpp>

#include <string>

namespace vfc {

class Input_error;

// returns a name of the package as a report spells it, with underscores instead of spaces
std::string report_name(std::string name);

// The report of a run: one JSON object that always has all keys. Those that do not apply, and
// numbers that are not finite, are null.
class Report
{
public:
  using Json = nlohmann::ordered_json;

  Report();

  // \pre the key is one of those in Report.cpp
  Json& operator[](const std::string& key) { return m_json.at(key); }
  const Json& operator[](const std::string& key) const { return m_json.at(key); }

  void set_error(const std::string& message);
  void set_error(const Input_error& error);

  // A member per line, or all in one line, without its end.
  std::string to_string() const;
  std::string to_line() const;

private:
  Json m_json;
};

} // namespace vfc

#endif // VFC_REPORT_H
