// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_ERRORS_H
#define VFC_ERRORS_H

#include <CGAL/Volume_filling_curves/IO/Curve_defect.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace vfc {

// The user asked for something that cannot be done; the message names the option.
class Usage_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

// The input is no valid curve.
class Input_error : public std::runtime_error
{
public:
  using Defects = std::vector<CGAL::Volume_filling_curves::Curve_defect>;

  // \pre one of the defects is an error
  Input_error(std::string file, Defects defects);

  const std::string& file() const { return m_file; }
  const Defects& defects() const { return m_defects; }
  const CGAL::Volume_filling_curves::Curve_defect& first_error() const;

private:
  std::string m_file;
  Defects m_defects;
};

class Console;

// Prints a line per defect, warnings only if the console is not quiet.
void print_defects(const Console& console,
                   const std::string& file,
                   const Input_error::Defects& defects);

} // namespace vfc

#endif // VFC_ERRORS_H
