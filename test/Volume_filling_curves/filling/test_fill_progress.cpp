// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/fill_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace test_fill_progress {

using namespace fill_test;
namespace np = CGAL::Volume_filling_curves::parameters;
using VFC::Filling_status;
using VFC::Run_progress;
using VFC::Run_stage;

const VFC::Ball_domain_3<Kernel> ball(Point(0, 0, 0), 1);

TEST(Fill_progress, has_all_stages_in_their_order)
{
  std::vector<Run_progress> reports;
  Curve curve;
  const auto note = [&](const Run_progress& progress) {
    reports.push_back(progress);
    return true;
  };
  const auto result = VFC::fill(curve, ball, preview(0.3).progress(note));
  ASSERT_EQ(result.status, Filling_status::CONVERGED);
  std::vector<Run_stage> stages;
  for(const Run_progress& progress : reports) {
    EXPECT_GE(progress.fraction, 0);
    EXPECT_LE(progress.fraction, 1);
    if(stages.empty() || stages.back() != progress.stage) stages.push_back(progress.stage);
  }
  EXPECT_EQ(stages, (std::vector<Run_stage>{Run_stage::PREPARING, Run_stage::BRANCHING,
                                            Run_stage::FLOWING, Run_stage::MEASURING}));
  EXPECT_EQ(reports.back().iterations, result.statistics.iterations);
  EXPECT_EQ(reports.back().nodes, curve.number_of_nodes());
  EXPECT_EQ(reports.back().gradient_norm, result.gradient_norm);
}

TEST(Fill_progress, ends_a_run_in_each_stage_with_a_valid_curve)
{
  for(const Run_stage last : {Run_stage::PREPARING, Run_stage::BRANCHING, Run_stage::FLOWING}) {
    Curve curve;
    const auto go_on = [&](const Run_progress& progress) { return progress.stage != last; };
    const auto result = VFC::fill(curve, ball, np::thickness(0.3).progress(go_on));
    EXPECT_EQ(result.status, Filling_status::INTERRUPTED) << last;
    expect_inside(curve, ball);
  }
}

TEST(Fill_progress, changes_nothing_of_the_curve)
{
  Curve watched, unwatched;
  VFC::fill(watched, ball, np::thickness(0.3).progress([](const Run_progress&) { return true; }));
  VFC::fill(unwatched, ball, np::thickness(0.3));
  ASSERT_EQ(watched.number_of_nodes(), unwatched.number_of_nodes());
  for(std::size_t v = 0; v < watched.number_of_nodes(); ++v)
    EXPECT_EQ(watched.point(v), unwatched.point(v));
}

} // namespace test_fill_progress
