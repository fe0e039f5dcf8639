// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace test_for_each_block {

using CGAL::Volume_filling_curves::internal::for_each_block;
using CGAL::Volume_filling_curves::internal::for_each_index;
using CGAL::Volume_filling_curves::internal::sum_over_indices;

template <typename Tag>
class For_each_block : public testing::Test
{};

#ifdef CGAL_LINKED_WITH_TBB
using Tags = testing::Types<CGAL::Sequential_tag, CGAL::Parallel_tag>;
#else
using Tags = testing::Types<CGAL::Sequential_tag>;
#endif

struct Name_of_tag
{
  template <typename Tag>
  static std::string GetName(int)
  {
    return std::is_same_v<Tag, CGAL::Sequential_tag> ? "sequential" : "parallel";
  }
};
TYPED_TEST_SUITE(For_each_block, Tags, Name_of_tag);

TYPED_TEST(For_each_block, covers_each_index_once)
{
  for(const std::size_t n : {0u, 1u, 9u, 10u, 11u, 5000u}) {
    std::vector<int> in_blocks(n, 0), one_by_one(n, 0);
    for_each_block<TypeParam>(n, 10, [&](std::size_t begin, std::size_t end) {
      EXPECT_EQ(begin % 10, 0u);
      EXPECT_LE(end, begin + 10);
      for(std::size_t i = begin; i < end; ++i) ++in_blocks[i];
    });
    for_each_index<TypeParam>(n, [&](std::size_t i) { ++one_by_one[i]; });
    EXPECT_EQ(in_blocks, std::vector<int>(n, 1));
    EXPECT_EQ(one_by_one, std::vector<int>(n, 1));
  }
}

TYPED_TEST(For_each_block, adds_up_to_the_same_bits)
{
  const auto f = [](std::size_t i) { return std::sin(static_cast<double>(i)); };
  EXPECT_EQ(sum_over_indices<TypeParam>(0, f), 0);
  EXPECT_EQ(sum_over_indices<TypeParam>(1, [](std::size_t) { return 0.1; }), 0.1);
  double sum = 0;
  for(std::size_t i = 0; i < 100000; ++i) sum += f(i);
  const double expected = sum_over_indices<CGAL::Sequential_tag>(100000, f);
  EXPECT_NEAR(expected, sum, 1e-9);
  for(int repeat = 0; repeat < 10; ++repeat)
    EXPECT_EQ(sum_over_indices<TypeParam>(100000, f), expected);
}

} // namespace test_for_each_block
