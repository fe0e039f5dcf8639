// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_REFUSAL_OF_H
#define VFC_TEST_REFUSAL_OF_H

#include <stdexcept>
#include <string>

// Returns the message of the exception by which a call refuses its input, or "" if it accepts it.
template <typename Error = std::invalid_argument, typename Call>
std::string refusal_of(const Call& call)
{
  try {
    call();
  } catch(const Error& error) {
    return error.what();
  }
  return "";
}

#endif // VFC_TEST_REFUSAL_OF_H
