// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/fill_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/simplify_curves.h>
#include <CGAL/Volume_filling_curves/untangle.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <thread>

// Certificates of runs that end while they still prepare: they are those of no change, whatever
// record they held before.
namespace test_certificates_of_short_runs {

using namespace fill_test;
namespace np = CGAL::Volume_filling_curves::parameters;
using VFC::Isotopy_certificate;

Isotopy_certificate certificate_of_another_run()
{
  Isotopy_certificate certificate;
  Curve other = VFC::make_hard_unknot<Curve::Traits>(200, 30, 2);
  VFC::simplify_curves(other, np::certificate(std::ref(certificate)));
  return certificate;
}

const auto stop = [](const VFC::Run_progress&) { return false; };

// Longer than the time that untangle() takes to end after its limit.
const auto sleep = [](const VFC::Run_progress&) {
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  return true;
};

void expect_no_change(const Isotopy_certificate& certificate, const Curve& start, const Curve& end)
{
  const auto verdict = VFC::verify_certificate(certificate, start, end);
  EXPECT_TRUE(verdict.is_valid) << verdict.sentence();
  EXPECT_EQ(verdict.number_of_operations, 0u);
}

TEST(Certificate_of_a_short_run, is_that_of_no_change)
{
  const Curve start = VFC::make_hard_unknot<Curve::Traits>(300, 300, 1);
  Curve curve = start;
  Isotopy_certificate certificate = certificate_of_another_run();
  VFC::simplify_curves(curve, np::certificate(std::ref(certificate)).progress(stop));
  expect_no_change(certificate, start, curve);
  certificate = certificate_of_another_run();
  VFC::untangle(curve, np::certificate(std::ref(certificate)).time_limit(0).progress(sleep));
  expect_no_change(certificate, start, curve);
}

// In a unit of its own as well, to which the record is scaled.
TEST(Certificate_of_a_short_run, is_that_of_the_start_of_a_filling)
{
  for(const double radius : {1., 1e60})
    for(const double seconds : {0., 1e-4, 1e-3, 1e-2, 0.1}) {
      const VFC::Ball_domain_3<Kernel> ball(Point(0, 0, 0), radius);
      Curve curve;
      Isotopy_certificate certificate = certificate_of_another_run();
      const auto result = VFC::fill(
          curve, ball,
          np::thickness(0.05 * radius).time_limit(seconds).certificate(std::ref(certificate)));
      const Curve start = result.start.empty() ? Curve() : Curve(result.start);
      const auto verdict = VFC::verify_certificate(certificate, start, curve);
      EXPECT_TRUE(verdict.is_valid) << radius << ' ' << seconds << ' ' << verdict.sentence();
    }
}

} // namespace test_certificates_of_short_runs
