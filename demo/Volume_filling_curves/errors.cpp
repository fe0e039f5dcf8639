// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "errors.h"

#include "Console.h"

#include <algorithm>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;

const curves::Curve_defect& first_error_of(const Input_error::Defects& defects)
{
  return *std::find_if(defects.begin(), defects.end(),
                       [](const curves::Curve_defect& d) { return curves::is_error(d.kind); });
}

} // namespace

Input_error::Input_error(std::string file, Defects defects)
    : std::runtime_error(curves::to_string(first_error_of(defects), file)),
      m_file(std::move(file)),
      m_defects(std::move(defects))
{}

const curves::Curve_defect& Input_error::first_error() const
{
  return first_error_of(m_defects);
}

void print_defects(const Console& console,
                   const std::string& file,
                   const Input_error::Defects& defects)
{
  for(const curves::Curve_defect& defect : defects)
    if(curves::is_error(defect.kind) || !console.is_quiet())
      console.print(curves::to_string(defect, file) + '\n');
}

} // namespace vfc
