// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CONSOLE_H
#define VFC_CONSOLE_H

#include <string>

namespace vfc {

enum class Verbosity
{
  QUIET,  // errors only
  NORMAL, // progress about once a second, warnings
  VERBOSE // every iteration
};

// Messages to the user, on standard error. Results are written to standard output elsewhere.
class Console
{
public:
  explicit Console(Verbosity verbosity);

  Verbosity verbosity() const { return m_verbosity; }
  bool is_quiet() const { return m_verbosity == Verbosity::QUIET; }
  bool is_terminal() const { return m_is_terminal; }

  // prints a line as it is, unless all but errors is to be quiet
  void note(const std::string& line) const;

  void warn(const std::string& message) const { note("vfc: warning: " + message); }
  void fail(const std::string& message) const { print("vfc: error: " + message + '\n'); }

  void print(const std::string& text) const;

private:
  Verbosity m_verbosity;
  bool m_is_terminal;
};

} // namespace vfc

#endif // VFC_CONSOLE_H
