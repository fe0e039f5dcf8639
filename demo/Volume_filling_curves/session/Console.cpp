// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "session/Console.h"

#include <cstdio>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace vfc {
namespace {

bool is_standard_error_a_terminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(STDERR_FILENO) != 0;
#endif
}

} // namespace

Console::Console(Verbosity verbosity)
    : m_verbosity(verbosity), m_is_terminal(is_standard_error_a_terminal())
{}

void Console::note(const std::string& line) const
{
  if(!is_quiet()) print(line + '\n');
}

// In one piece, which keeps the lines of several runs apart.
void Console::print(const std::string& text) const
{
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

} // namespace vfc
