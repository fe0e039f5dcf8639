// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_NO_RESULT_H
#define VFC_NO_RESULT_H

#include "session/Exit_status.h"

#include <stdexcept>
#include <string>

namespace vfc {

// Exception of a command that ended without a result, by its time limit or by the user.
class No_result : public std::runtime_error
{
public:
  No_result(Exit_status status, const std::string& message)
      : std::runtime_error(message), m_status(status)
  {}

  Exit_status status() const { return m_status; }

private:
  Exit_status m_status;
};

} // namespace vfc

#endif // VFC_NO_RESULT_H
