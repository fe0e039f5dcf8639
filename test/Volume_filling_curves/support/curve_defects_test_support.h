// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CURVE_DEFECTS_TEST_SUPPORT_H
#define VFC_CURVE_DEFECTS_TEST_SUPPORT_H

#include <CGAL/Volume_filling_curves/IO/curve_network.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

// Defects in the texts of curve files.
namespace curve_defects_test {

using namespace CGAL::Volume_filling_curves;

using Kind = Curve_defect_kind;
using Nodes = std::vector<std::size_t>;
using Network = Curve_network_3<>;

inline std::vector<Curve_defect> check(internal::Curve_draft file, Junctions junctions)
{
  Network network;
  std::vector<Curve_defect> defects;
  internal::draft_to_embedded_network(file, network, defects, junctions);
  return defects;
}

inline std::vector<Curve_defect> check_obj(const std::string& text,
                                           Junctions junctions = Junctions::FORBIDDEN)
{
  return check(internal::read_obj(text, junctions), junctions);
}

inline std::vector<Curve_defect> check_txt(const std::string& text,
                                           Junctions junctions = Junctions::FORBIDDEN)
{
  return check(internal::read_polylines_txt(text, junctions), junctions);
}

inline bool has_error(const std::vector<Curve_defect>& defects)
{
  return std::any_of(defects.begin(), defects.end(),
                     [](const Curve_defect& defect) { return is_error(defect.kind); });
}

inline bool has(const std::vector<Curve_defect>& defects, Kind kind)
{
  return std::any_of(defects.begin(), defects.end(),
                     [&](const Curve_defect& defect) { return defect.kind == kind; });
}

inline void expect_only(const std::vector<Curve_defect>& defects,
                        Kind kind,
                        std::size_t line,
                        const Nodes& nodes)
{
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].kind, kind) << to_string(defects[0].kind);
  EXPECT_EQ(defects[0].line, line);
  EXPECT_EQ(defects[0].nodes, nodes);
}

inline const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

} // namespace curve_defects_test

#endif // VFC_CURVE_DEFECTS_TEST_SUPPORT_H
