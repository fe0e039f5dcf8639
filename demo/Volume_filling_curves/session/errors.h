// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_ERRORS_H
#define VFC_ERRORS_H

#include "reports/Defect.h"

#include <stdexcept>
#include <string>

namespace vfc {

// Error of usage: an impossible request; the message names the option.
class Usage_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

// Error of an output whose file has appeared during the run, and is kept: the message names the
// file that holds the output.
class Kept_file : public Usage_error
{
public:
  using Usage_error::Usage_error;
};

// Error of an input, which is not what it should be, such as "a valid curve".
class Input_error : public std::runtime_error
{
public:
  // \pre one of the defects is an error
  Input_error(Defects defects, const std::string& expected);

  const Defects& defects() const { return m_defects; }
  const Defect& first_error() const;

private:
  Defects m_defects;
};

class Console;

// Prints a line per defect, but only ten of each kind and how many more there are; warnings only if
// the console is not quiet.
void print_defects(const Console& console, const Defects& defects);

} // namespace vfc

#endif // VFC_ERRORS_H
