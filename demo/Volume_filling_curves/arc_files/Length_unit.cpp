// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "arc_files/Length_unit.h"

#include "formats/curve_formats.h"
#include "meshes/read_mesh_soup.h"
#include "options/option_kinds.h"
#include "session/errors.h"

namespace vfc {

std::string to_string(Length_unit unit)
{
  switch(unit) {
  case Length_unit::MILLIMETER:
    return "mm";
  case Length_unit::CENTIMETER:
    return "cm";
  case Length_unit::METER:
    return "m";
  case Length_unit::INCH:
    return "inch";
  default:
    return "";
  }
}

CLI::Option& add_unit_option(CLI::App& command, Length_unit& unit)
{
  return *add_choice<Length_unit>(command, "--unit", unit,
                                  {{"mm", Length_unit::MILLIMETER},
                                   {"cm", Length_unit::CENTIMETER},
                                   {"m", Length_unit::METER},
                                   {"inch", Length_unit::INCH}},
                                  "mm, cm, m or inch: the unit of CURVE, noted in .step, .svg and "
                                  ".stl files, which keep the numbers; .step takes mm without it")
              .default_str("");
}

void check_unit(Length_unit unit, const std::string& file)
{
  const std::string extension = lower_case_extension(file);
  if(unit == Length_unit::NONE || extension == ".step" || extension == ".stp" ||
     extension == ".svg" || extension == ".stl")
    return;
  throw Usage_error("--unit: " + extension +
                    " files hold no unit; their numbers are in the unit of CURVE");
}

} // namespace vfc
