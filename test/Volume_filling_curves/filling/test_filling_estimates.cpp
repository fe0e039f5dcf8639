// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/internal/filling/Filling_size.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_estimates.h>

#include <gtest/gtest.h>

#include <cmath>

namespace test_filling_estimates {

using CGAL::Volume_filling_curves::length_of_filling;
using CGAL::Volume_filling_curves::thickness_of_filling;

TEST(Filling_estimates, are_each_other_s_inverse)
{
  for(const double volume : {1e-6, 1., 4e9})
    for(const double thickness : {1e-3, 0.1, 20.})
      EXPECT_NEAR(thickness_of_filling(volume, length_of_filling(volume, thickness)) / thickness, 1,
                  1e-14);
}

TEST(Filling_estimates, scale_with_the_domain)
{
  const double unit = std::ldexp(1, 20);
  const double volume = 3, thickness = 0.1, length = 70;
  EXPECT_EQ(length_of_filling(unit * unit * unit * volume, unit * thickness),
            unit * length_of_filling(volume, thickness));
  EXPECT_EQ(thickness_of_filling(unit * unit * unit * volume, unit * length),
            unit * thickness_of_filling(volume, length));
}

// A strand has a tube to itself whose cross section is a hexagon as wide as the strands are apart,
// of the area sqrt(3) / 2 d^2, or somewhat more: at least 1.6 r if the filling is round, and 1.66 r
// to 1.77 r at the median if it is not.
TEST(Filling_estimates, leave_every_strand_a_tube)
{
  const auto hexagon = [](double width) { return std::sqrt(3.) / 2 * width * width; };
  EXPECT_GT(1 / length_of_filling(1, 1), hexagon(1.6));
  EXPECT_LT(1 / length_of_filling(1, 1), hexagon(2));
  EXPECT_GT(1 / length_of_filling(1, 1, false), hexagon(1.77));
  EXPECT_LT(1 / length_of_filling(1, 1, false), hexagon(2.1));
}

// A torus of radii 1 and 0.35, filled with r = 0.0402: its nodes and CPU seconds.
TEST(Filling_estimates, tell_a_round_filling_from_another)
{
  const double volume = 2.404, r = 0.0402;
  const CGAL::Volume_filling_curves::internal::Filling_size plain(volume, {}, 0.2),
      round(volume, {}, 0.2, 3, true);
  EXPECT_NEAR(plain.number_of_nodes(r) / 36420, 1, 0.1);
  EXPECT_NEAR(plain.seconds(r) / 5.8, 1, 0.2);
  EXPECT_NEAR(round.number_of_nodes(r) / 30703, 1, 0.1);
  EXPECT_NEAR(round.seconds(r) / 14.5, 1, 0.2);
  EXPECT_NEAR(round.length(r) / plain.length(r), 0.38 / 0.28, 1e-9);
  EXPECT_EQ(round.thickness_with(1e5), plain.thickness_with(1e5)); // as many on the way
}

} // namespace test_filling_estimates
