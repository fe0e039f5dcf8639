// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/repair_test_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace test_repair_time {

using namespace repair_test;

// A tire: a torus whose treads are so steep that each leans over and through the next ones.
Soup tire(std::size_t treads, std::size_t along, std::size_t around)
{
  const double pi = std::acos(-1.), n = static_cast<double>(treads);
  Soup soup;
  for(std::size_t i = 0; i < along; ++i)
    for(std::size_t j = 0; j < around; ++j) {
      const double u = 2 * pi * static_cast<double>(i) / static_cast<double>(along);
      const double v = 2 * pi * static_cast<double>(j) / static_cast<double>(around);
      const double tread = std::sqrt((std::max)(0., std::cos(v))), phase = n * u + 5 * v;
      const double turn = u + 2.5 * tread / n * std::sin(phase);
      const double tube = 0.35 + 1.5 * tread / n * std::cos(phase), r = 1 + tube * std::cos(v);
      soup.points.emplace_back(r * std::cos(turn), r * std::sin(turn), tube * std::sin(v));
    }
  for(std::size_t i = 0; i < along; ++i)
    for(std::size_t j = 0; j < around; ++j) {
      const std::size_t k = (i + 1) % along, l = (j + 1) % around;
      const std::size_t a = i * around + j, b = k * around + j, c = k * around + l;
      soup.faces.push_back({a, b, c});
      soup.faces.push_back({a, c, i * around + l});
    }
  return soup;
}

TEST_F(Repair, mends_a_tire_whose_treads_intersect)
{
  mend(tire(20, 120, 30));
  EXPECT_NEAR(volume(), 2.4, 0.4);
}

TEST_F(Repair, ends_at_once_if_there_is_no_time)
{
  vfc::Work_watch no_time(0);
  EXPECT_THROW(vfc::repair_mesh(faces_of(tire(4, 20, 6)), 0, mesh, no_time), vfc::Work_stopped);
}

// The first call comes from the beginning of a step, all others from within it.
TEST_F(Repair, can_be_interrupted_within_long_steps)
{
  const Soup soup = tire(20, 120, 30);
  for(const std::string long_step : {"removing self-intersections", "wrapping"}) {
    std::size_t calls = 0;
    vfc::Work_watch watch(vfc::Work_watch::never, [&](const std::string& step, double) {
      return step != long_step || ++calls < 3;
    });
    Soup broken = soup;
    if(long_step == "wrapping") broken += meshes::voxels({{9, 0, 0}, {10, 1, 0}});
    EXPECT_THROW(vfc::repair_mesh(faces_of(broken), 0, mesh, watch), vfc::Work_stopped);
    EXPECT_EQ(watch.step(), long_step);
    EXPECT_TRUE(watch.is_interrupted());
  }
}

} // namespace test_repair_time
