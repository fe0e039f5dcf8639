// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_FILL_ROUND_TEST_SUPPORT_H
#define VFC_TEST_FILL_ROUND_TEST_SUPPORT_H

#include "support/fill_test_support.h"

#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/domain/Polygon_domain_3.h>

#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

// Common parts of the tests of round fillings.
namespace fill_round_test {

using namespace fill_test;
namespace np = CGAL::Volume_filling_curves::parameters;
using VFC::Filling_status;
using Box = VFC::Box_domain_3<Kernel>;
using Plate = VFC::Polygon_domain_3<Traits>;
using Result = VFC::Filling_result<Point>;

inline const Box box({0, 0, 0}, {6, 6, 6});

// By the measures, which count strands from half of a turn of the bend radius on.
inline void expect_shape(const Curve& curve, double bend_radius, double strand_distance)
{
  EXPECT_GE(VFC::min_bend_radius(curve), (1 - 1e-9) * bend_radius);
  EXPECT_GE(VFC::min_clearance(curve, CGAL_PI * bend_radius), (1 - 1e-9) * strand_distance);
}

} // namespace fill_round_test

#endif // VFC_TEST_FILL_ROUND_TEST_SUPPORT_H
