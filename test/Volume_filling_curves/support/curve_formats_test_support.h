// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_CURVE_FORMATS_TEST_SUPPORT_H
#define VFC_TEST_CURVE_FORMATS_TEST_SUPPORT_H

#include "files/curve_files.h"
#include "formats/curve_formats.h"
#include "formats/readers.h"
#include "support/curve_io_test_support.h"

#include <optional>
#include <string>

// Curves in the formats of the program.
namespace curve_formats_test {

using namespace curve_io_test;

inline Reading read_vect(const std::string& text)
{
  return read(vfc::read_vect(text, Junctions::FORBIDDEN), Junctions::FORBIDDEN);
}

inline Reading read_point_list(const std::string& text)
{
  return read(vfc::read_point_list(text, Junctions::FORBIDDEN), Junctions::FORBIDDEN);
}

inline Reading read_pdb(const std::string& text)
{
  return read(vfc::read_pdb(text, Junctions::FORBIDDEN), Junctions::FORBIDDEN);
}

inline Reading read_mmcif(const std::string& text)
{
  return read(vfc::read_mmcif(text, Junctions::FORBIDDEN), Junctions::FORBIDDEN);
}

inline Reading read_ply(const std::string& text, Junctions junctions = Junctions::FORBIDDEN)
{
  return read(vfc::read_ply(text, junctions), junctions);
}

inline Reading read_vtp(const std::string& text, Junctions junctions = Junctions::FORBIDDEN)
{
  return read(vfc::read_vtp(text, junctions), junctions);
}

// reads a file of any format
inline Reading read_file(const std::string& file, std::optional<Closure> closure = std::nullopt)
{
  const Junctions junctions = Junctions::FORBIDDEN;
  return read(internal::read_curve_draft(vfc::curve_formats(), file, junctions, closure),
              junctions);
}

} // namespace curve_formats_test

#endif // VFC_TEST_CURVE_FORMATS_TEST_SUPPORT_H
