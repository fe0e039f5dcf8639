// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The names of statuses, proofs and choices, which users print.

#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_result.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Polyline_conventions.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_result.h>

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

namespace test_names {

using namespace CGAL::Volume_filling_curves;

template <typename Enum>
std::string written(Enum value)
{
  std::ostringstream text;
  text << value;
  EXPECT_EQ(text.str(), to_string(value));
  return text.str();
}

// The names of all values up to the last, of which no two are alike.
template <typename Enum>
void expect_names_up_to(Enum last)
{
  std::set<std::string> names;
  for(int k = 0; k <= static_cast<int>(last); ++k) names.insert(written(static_cast<Enum>(k)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(last) + 1);
  EXPECT_EQ(names.count(""), 0u);
}

TEST(Names, are_plain_english)
{
  EXPECT_EQ(written(Untangling_status::UNKNOTTED), "unknotted");
  EXPECT_EQ(written(Unknot_proof::TOTAL_CURVATURE), "total curvature");
  EXPECT_EQ(written(Link_status::NOT_A_LINK), "not a link");
  EXPECT_EQ(written(Filling_status::CONVERGED), "converged");
  EXPECT_EQ(written(Filling_status::PARTIAL), "partial");
  EXPECT_EQ(written(Untangling_strategy::SEARCH), "search");
  EXPECT_EQ(written(Preconditioner::QUASI_NEWTON), "quasi-newton");
  EXPECT_EQ(written(Preconditioner::CONTACT), "contact");
  EXPECT_EQ(written(Wall::KEEP_CLEAR), "keep clear");
  EXPECT_EQ(written(Closure::IF_REPEATED), "if repeated");
  EXPECT_EQ(written(Junctions::FORBIDDEN), "forbidden");
  EXPECT_EQ(written(Curve_defect_kind::SELF_CONTACT), "self-contact");
}

TEST(Names, exist_for_every_value)
{
  expect_names_up_to(Untangling_status::INTERRUPTED);
  expect_names_up_to(Unknot_proof::TOTAL_CURVATURE);
  expect_names_up_to(Link_status::UNDECIDED);
  expect_names_up_to(Filling_status::INTERRUPTED);
  expect_names_up_to(Untangling_strategy::AUTO);
  expect_names_up_to(Preconditioner::CONTACT);
  expect_names_up_to(Wall::KEEP_CLEAR);
  expect_names_up_to(Closure::OPEN);
  expect_names_up_to(Junctions::ALLOWED);
  expect_names_up_to(Curve_defect_kind::SELF_CONTACT);
}

} // namespace test_names
