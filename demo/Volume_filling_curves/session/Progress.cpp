// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "session/Progress.h"

#include <algorithm>
#include <cstddef>

namespace vfc {

Progress::~Progress()
{
  if(m_is_bar_visible) m_console.print("\r\033[K");
}

bool Progress::is_due()
{
  using namespace std::chrono_literals;
  if(m_console.is_quiet()) return false;
  if(m_console.verbosity() == Verbosity::VERBOSE) return true;
  const Clock::time_point now = Clock::now();
  if(now - m_last < (has_bar() ? 100ms : 1000ms)) return false;
  m_last = now;
  return true;
}

void Progress::show(double part, const std::string& text)
{
  if(!has_bar()) return m_console.note(text);
  constexpr std::size_t width = 20;
  const auto done = static_cast<std::size_t>(static_cast<double>(width) * std::clamp(part, 0., 1.));
  m_console.print("\r[" + std::string(done, '#') + std::string(width - done, ' ') + "] " + text +
                  "\033[K");
  m_is_bar_visible = true;
}

} // namespace vfc
