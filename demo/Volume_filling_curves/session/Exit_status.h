// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_EXIT_STATUS_H
#define VFC_EXIT_STATUS_H

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

} // namespace vfc

#endif // VFC_EXIT_STATUS_H
