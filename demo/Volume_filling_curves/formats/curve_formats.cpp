// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/curve_formats.h"

#include "formats/readers.h"
#include "formats/writers.h"

#include <iterator>

namespace vfc {

const std::vector<Curve_format>& curve_formats()
{
  static const std::vector<Curve_format> all = [] {
    std::vector<Curve_format> formats;
    for(const auto& format : CGAL::Volume_filling_curves::internal::curve_formats)
      formats.push_back({format});
    formats.push_back({{".ply", read_ply, nullptr, true}, to_ply});
    formats.push_back({{".vtp", read_vtp, nullptr, true}, to_vtp});
    formats.push_back({{".vect", read_vect, to_vect}});
    for(const char* extension : {".xyz", ".txt", ".dat"})
      formats.push_back({{extension, read_point_list, to_point_list}});
    for(const char* extension : {".pdb", ".ent"})
      formats.push_back({{extension, read_pdb, nullptr}});
    formats.push_back({{".cif", read_mmcif, nullptr}});
    return formats;
  }();
  return all;
}

const Curve_format* curve_format_of(const std::string& file)
{
  return CGAL::Volume_filling_curves::internal::find_format(curve_formats(), file);
}

} // namespace vfc
