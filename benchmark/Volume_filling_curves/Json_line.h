// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_BENCHMARK_JSON_LINE_H
#define VFC_BENCHMARK_JSON_LINE_H

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace vfc_benchmark {

// A JSON object on one line.
class Json_line
{
public:
  template <typename Value>
  Json_line& add(const std::string& key, const Value& value)
  {
    m_members += (m_members.empty() ? "" : ", ") + quoted(key) + ": " + text(value);
    return *this;
  }

  std::string str() const { return '{' + m_members + '}'; }

private:
  static std::string quoted(const std::string& s)
  {
    std::string result = "\"";
    for(char c : s) {
      if(c == '"' || c == '\\') result += '\\';
      result += c;
    }
    return result + '"';
  }

  static std::string text(const std::string& s) { return quoted(s); }
  static std::string text(const char* s) { return quoted(s); }
  static std::string text(bool b) { return b ? "true" : "false"; }
  static std::string text(const Json_line& object) { return object.str(); }

  template <typename T>
  static std::string text(const std::vector<T>& items)
  {
    std::string result;
    for(const T& item : items) result += (result.empty() ? "" : ", ") + text(item);
    return '[' + result + ']';
  }

  template <typename T, typename = std::enable_if_t<std::is_arithmetic<T>::value>>
  static std::string text(T number)
  {
    if constexpr(std::is_floating_point<T>::value)
      if(!std::isfinite(number)) return "null";
    std::ostringstream out;
    out.precision(std::numeric_limits<double>::max_digits10);
    out << number;
    return out.str();
  }

  std::string m_members;
};

} // namespace vfc_benchmark

#endif // VFC_BENCHMARK_JSON_LINE_H
