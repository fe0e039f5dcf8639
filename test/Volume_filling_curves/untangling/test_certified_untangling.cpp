// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/certificate_test_support.h"
#include "support/cpu_time.h"
#include "support/shared_curves.h"

#include <CGAL/Volume_filling_curves/IO/curve_network.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace test_certified_untangling {

using namespace certificate_test;
namespace parameters = CGAL::Volume_filling_curves::parameters;
using CGAL::Volume_filling_curves::Certificate_verdict;
using CGAL::Volume_filling_curves::make_closed_braid;
using CGAL::Volume_filling_curves::parse_braid_word;
using CGAL::Volume_filling_curves::untangle;
using CGAL::Volume_filling_curves::verify_certificate;

// The closure of a braid, tangled.
Network braid(const std::string& word, std::uint64_t seed)
{
  Network curve = scaled(make_closed_braid(parse_braid_word(word), 90, 0, 1), -3);
  Guard guard(curve);
  internal::Random_tangler<Network::Traits>(guard, seed).tangle(1000, 0.5);
  return curve;
}

// Untangles a curve, and verifies the certificate of that.
template <typename NamedParameters>
Certificate_verdict untangle_and_verify(const Network& start, const NamedParameters& np)
{
  Isotopy_certificate certificate;
  Network end = start;
  untangle(end, np.certificate(std::ref(certificate)));
  return verify_certificate(certificate, start, end);
}

void expect_valid(const Certificate_verdict& verdict)
{
  EXPECT_TRUE(verdict.is_valid) << verdict.operation << ": " << verdict.message;
  EXPECT_GT(verdict.number_of_operations, 0u);
}

TEST(Certified_untangling, covers_knots_links_and_rescaling)
{
  for(const char* word : {"1 1 1", "1 -2 1 -2", "1 1", "1 -2 1 -2 1 -2"})
    for(const bool keeps_length : {false, true})
      expect_valid(untangle_and_verify(
          braid(word, 1), parameters::number_of_iterations(20).keep_length(keeps_length)));
}

// Closing_rays, with which the ends of open curves are prolonged for a while, are left out.
TEST(Certified_untangling, covers_arcs)
{
  std::vector<Network::Point_3> points;
  for(int k = 0; k < 40; ++k) {
    const double t = 0.3 * k;
    points.emplace_back(std::cos(t), std::sin(2 * t), 0.1 * t * std::sin(3 * t));
  }
  std::vector<std::array<std::size_t, 2>> edges;
  for(std::size_t v = 1; v < points.size(); ++v) edges.push_back({v - 1, v});
  for(const bool are_pinned : {false, true}) {
    Network arc(points, edges);
    if(are_pinned) arc.pin_ends();
    expect_valid(untangle_and_verify(arc, parameters::number_of_iterations(20)));
  }
}

TEST(Certified_untangling, does_the_same_as_without_a_certificate)
{
  const Network start = braid("1 1 1", 2);
  Network plain = start, recorded = start;
  Isotopy_certificate certificate;
  untangle(plain, parameters::number_of_iterations(30));
  untangle(recorded, parameters::number_of_iterations(30).certificate(std::ref(certificate)));
  EXPECT_EQ(contents(plain), contents(recorded));
}

TEST(Certified_untangling, does_not_depend_on_the_number_of_threads)
{
  const Network start = braid("1 1 1", 3);
  Isotopy_certificate sequential, parallel;
  Network a = start, b = start;
  untangle(a, parameters::number_of_iterations(30).certificate(std::ref(sequential)));
  untangle<CGAL::Parallel_if_available_tag>(
      b, parameters::number_of_iterations(30).certificate(std::ref(parallel)));
  EXPECT_EQ(sequential.bytes(), parallel.bytes());
}

class Certified_untangling_of_shared_curves : public shared_curves::Shared_data_test
{};

// The certificate of the written file, also read again in the other format.
TEST_F(Certified_untangling_of_shared_curves, holds_for_the_files)
{
  const std::string input = (shared_curves::folder() / "paper/goeritz.obj").string();
  const std::string folder = testing::TempDir();
  Network start, curve;
  ASSERT_TRUE(CGAL::IO::read_curve_network(input, start));
  ASSERT_TRUE(CGAL::IO::read_curve_network(input, curve));
  Isotopy_certificate certificate;
  untangle(curve, parameters::keep_length(true).certificate(std::ref(certificate)));
  for(const std::string name : {"certified_end.obj", "certified_end.polylines.txt"}) {
    ASSERT_TRUE(CGAL::IO::write_curve_network(folder + name, curve));
    Network end;
    ASSERT_TRUE(CGAL::IO::read_curve_network(folder + name, end));
    expect_valid(verify_certificate(certificate, start, end));
    std::filesystem::remove(folder + name);
  }
}

TEST_F(Certified_untangling_of_shared_curves, holds_for_one_knot_of_each_crossing_number)
{
  std::set<int> crossing_numbers;
  for(const shared_curves::Known_curve& known : shared_curves::known_curves({"knot128"})) {
    if(!crossing_numbers.insert(known.crossing_number).second) continue;
    Network start;
    ASSERT_TRUE(CGAL::IO::read_curve_network(known.path(), start));
    expect_valid(untangle_and_verify(start, parameters::number_of_iterations(1000)));
  }
  EXPECT_GT(crossing_numbers.size(), 3u);
}

// A run with a certificate may take twice as long, and takes hardly longer.
TEST_F(Certified_untangling_of_shared_curves, takes_hardly_longer)
{
  Network start;
  ASSERT_TRUE(CGAL::IO::read_curve_network(
      (shared_curves::folder() / "paper/freedman_he_wang.obj").string(), start));
  const auto run = [&](const auto& np) {
    Network curve = start;
    untangle(curve, np);
  };
  Isotopy_certificate certificate;
  const auto np = parameters::number_of_iterations(60);
  const auto certified = np.certificate(std::ref(certificate));
  EXPECT_LT(cpu_time::ratio([&] { run(certified); }, [&] { run(np); }), 2);
}

} // namespace test_certified_untangling
