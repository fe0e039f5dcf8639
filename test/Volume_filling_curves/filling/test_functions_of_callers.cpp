// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/fill_test_support.h"

#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/identify.h>
#include <CGAL/Volume_filling_curves/simplify_curves.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

// What progress functions and visitors may do: call the library, whose calls are none of the run,
// and end a run by an exception, which leaves a curve without garbage.
namespace test_functions_of_callers {

using namespace fill_test;
namespace np = CGAL::Volume_filling_curves::parameters;
using Box = VFC::Box_domain_3<Kernel>;
using Polyline = std::vector<Point>;
using Progress = std::function<bool(const VFC::Run_progress&)>;
using Run = std::function<void(Curve&, const Progress&)>;

void simplify(Curve& curve, const Progress& progress)
{
  curve = VFC::make_random_polygon<Curve::Traits>(10000, 1);
  VFC::simplify_curves(curve, np::progress(progress));
}

void untangle(Curve& curve, const Progress& progress)
{
  curve = VFC::make_hard_unknot<Curve::Traits>(600, 300, 1);
  VFC::untangle(
      curve,
      np::strategy(VFC::Untangling_strategy::FLOW).number_of_iterations(30).progress(progress));
}

void fill_box(Curve& curve, const Progress& progress)
{
  VFC::fill(curve, Box(Point(0, 0, 0), Point(1, 1, 1)), np::thickness(0.2).progress(progress));
}

// Each run with its name.
const std::vector<std::pair<std::string, Run>> runs = {
    {"simplify", simplify}, {"untangle", untangle}, {"fill", fill_box}};

TEST(Functions_of_callers, may_call_the_library)
{
  const Curve other = VFC::make_torus_knot<Curve::Traits>(2, 3, 200);
  for(const auto& [name, run] : runs) {
    int depth = 0, deepest = 0, calls = 0;
    const auto measure_other = [&](const VFC::Run_progress&) {
      deepest = (std::max)(deepest, ++depth);
      if(++calls <= 3 && depth < 5) {
        EXPECT_EQ(VFC::measure(other, 0.1).component_lengths.size(), 1u);
        EXPECT_EQ(VFC::identify(other).name, "3_1");
        Curve copy = other;
        VFC::untangle(copy);
      }
      --depth;
      return true;
    };
    Curve curve;
    run(curve, measure_other);
    EXPECT_EQ(deepest, 1) << name;
    EXPECT_GT(calls, 1) << name;
  }
}

constexpr double time_limit = 2;

// After the first step it waits until the limit is over.
struct Slow_visitor : VFC::Default_curve_flow_visitor
{
  template <typename Flow>
  void on_iteration(const Flow& flow)
  {
    std::this_thread::sleep_until(end);
    has_measured = VFC::measure(flow.curve(), 0.1).component_lengths.size() == 1;
  }

  const std::chrono::steady_clock::time_point end =
      std::chrono::steady_clock::now() + std::chrono::milliseconds(int(1100 * time_limit));
  bool has_measured = false;
};

TEST(Functions_of_callers, may_call_the_library_after_the_time_limit)
{
  Curve curve;
  Slow_visitor visitor;
  const auto result =
      VFC::fill(curve, Box(Point(0, 0, 0), Point(1, 1, 1)),
                np::thickness(0.2).time_limit(time_limit).visitor(std::ref(visitor)));
  EXPECT_EQ(result.status, VFC::Filling_status::LIMIT);
  EXPECT_TRUE(visitor.has_measured || result.statistics.iterations == 0); // on a slow machine
}

TEST(Functions_of_callers, may_throw_at_any_time)
{
  for(const auto& [name, run] : runs)
    for(int last = 1, calls = 0; last < 200; last += 1 + last / 2) {
      calls = 0;
      Curve curve;
      const auto throw_at_last = [&](const VFC::Run_progress&) {
        if(++calls == last) throw std::domain_error("enough");
        return true;
      };
      try {
        run(curve, throw_at_last);
        EXPECT_GT(last, 3) << name;
        break;
      } catch(const std::domain_error&) {
        EXPECT_FALSE(curve.has_garbage()) << name << ' ' << last;
        EXPECT_NO_THROW((void)VFC::measure(curve, 0.1)) << name << ' ' << last;
      }
    }
}

// Its closing rays end with the run.
TEST(Functions_of_callers, may_throw_while_an_arc_has_rays)
{
  for(int last = 2; last < 100; last += last / 2) {
    Polyline points;
    for(int k = 0; k < 3000; ++k)
      points.push_back(Point(0.01 * k, std::sin(0.05 * k), std::cos(0.08 * k)));
    Curve arc(std::vector<Polyline>{points});
    arc.pin_ends();
    int calls = 0;
    const auto throw_at_last = [&](const VFC::Run_progress&) {
      if(++calls == last) throw std::domain_error("enough");
      return true;
    };
    try {
      VFC::untangle(arc, np::strategy(VFC::Untangling_strategy::FLOW)
                             .thickness(1)
                             .number_of_iterations(10)
                             .progress(throw_at_last));
      break;
    } catch(const std::domain_error&) {
      EXPECT_FALSE(arc.has_garbage());
      for(std::size_t v = 0; v < arc.number_of_nodes(); ++v)
        EXPECT_EQ(arc.degree(v) == 1, arc.is_pinned(v)) << last;
    }
  }
}

} // namespace test_functions_of_callers
