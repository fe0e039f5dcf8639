// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PROGRESS_H
#define VFC_PROGRESS_H

#include "session/Console.h"

#include <chrono>
#include <string>

namespace vfc {

// Progress of a run: a bar on a terminal, plain lines in a pipe.
class Progress
{
public:
  explicit Progress(const Console& console) : m_console(console) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Removes the bar.
  ~Progress();

  // returns whether it is time to show something
  bool is_due();

  // shows the part of the work that is done, from 0 to 1, and a short text
  void show(double part, const std::string& text);

private:
  using Clock = std::chrono::steady_clock;

  bool has_bar() const
  {
    return m_console.is_terminal() && m_console.verbosity() == Verbosity::NORMAL;
  }

  const Console& m_console;
  Clock::time_point m_last = Clock::now();
  bool m_is_bar_visible = false;
};

} // namespace vfc

#endif // VFC_PROGRESS_H
