// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/flow_test_support.h"

#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>

#include <gtest/gtest.h>

#include <cstddef>

namespace test_segment_passage {

using namespace flow_test;
using internal::Segment_pair;

// Segments along u and v whose middles are at a height and a distance along u.
Segment_pair crossing(const Vector& u, const Vector& v, double height, double shift)
{
  const Vector middle = height * u.cross(v).normalized() + shift * u;
  return {middle - u, middle + u, -1 * v, v};
}

TEST(Segment_passage, is_noticed_where_segments_meet)
{
  Random random(1);
  for(int repeat = 0; repeat < 1000; ++repeat) {
    const Vector u = random_point(random), v = random_point(random);
    const double before = between(0.1, 1, random), after = between(0.1, 1, random);
    const double shift = between(-0.9, 0.9, random), beside = between(1.1, 2, random);
    ASSERT_TRUE(do_pass(crossing(u, v, before, shift), crossing(u, v, -after, shift)));
    ASSERT_FALSE(do_pass(crossing(u, v, before, beside), crossing(u, v, -after, beside)));
    ASSERT_FALSE(do_pass(crossing(u, v, before, -shift), crossing(u, v, after, shift)));
  }
}

// The segments turn as they pass.
TEST(Segment_passage, is_the_same_in_both_directions_of_time)
{
  Random random(2);
  int passages = 0;
  for(int repeat = 0; repeat < 10000; ++repeat) {
    Segment_pair from, to;
    for(std::size_t k = 0; k < from.size(); ++k) {
      from[k] = random_point(random);
      to[k] = random_point(random);
    }
    const bool do_pass = internal::do_pass(from, to);
    ASSERT_EQ(do_pass, internal::do_pass({to[1], to[0], to[2], to[3]},
                                         {from[1], from[0], from[2], from[3]}));
    passages += do_pass;
  }
  EXPECT_GT(passages, 100);
}

TEST(Segment_passage, is_ruled_out_at_once_for_most_strands)
{
  Random random(3);
  for(int repeat = 0; repeat < 1000; ++repeat) {
    const Vector apart = 3 * random_point(random).normalized();
    Segment_pair from, to;
    for(std::size_t k = 0; k < from.size(); ++k) {
      from[k] = random_point(random) / 4 + (k < 2 ? apart : Vector());
      to[k] = random_point(random) / 4 + (k < 2 ? apart : Vector());
    }
    ASSERT_FALSE(internal::may_meet(from, to));
  }
}

} // namespace test_segment_passage
