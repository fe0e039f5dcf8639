// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_EXIT_STATUS_H
#define VFC_EXIT_STATUS_H

#include <algorithm>
#include <array>

namespace vfc {

// Exit statuses of the program; scripts rely on the numbers.
enum Exit_status
{
  GOAL_REACHED = 0,
  FAILURE = 1, // wrong options, existing output, unwritable path, internal error
  LIMIT_REACHED = 2,
  STALLED = 3,
  INVALID_INPUT = 4,
  INTERRUPTED = 5
};

// Returns the more severe of two statuses. An interruption is the most severe: runs are missing.
inline int more_severe(int a, int b)
{
  constexpr std::array order = {GOAL_REACHED,  LIMIT_REACHED, STALLED,
                                INVALID_INPUT, FAILURE,       INTERRUPTED};
  const auto gravity = [&](int status) { return std::find(order.begin(), order.end(), status); };
  return gravity(a) < gravity(b) ? b : a;
}

} // namespace vfc

#endif // VFC_EXIT_STATUS_H
