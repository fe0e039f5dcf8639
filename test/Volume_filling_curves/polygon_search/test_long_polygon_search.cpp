// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/guard_test_support.h"
#include "support/knot_invariants.h"
#include "support/shared_curves.h"

#include <CGAL/Volume_filling_curves/IO/curve_network.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

// Results of the random search, and of the search with the flow, on the shared curves.
namespace test_long_polygon_search {

namespace parameters = CGAL::Volume_filling_curves::parameters;
using CGAL::Volume_filling_curves::untangle;
using CGAL::Volume_filling_curves::Untangling_result;
using CGAL::Volume_filling_curves::Untangling_status;
using CGAL::Volume_filling_curves::Untangling_strategy;
using Network = CGAL::Volume_filling_curves::Curve_network_3<>;
using shared_curves::Known_curve;

class Long_polygon_search : public shared_curves::Shared_data_test
{};

Network read(const std::string& path)
{
  Network curve;
  EXPECT_TRUE(CGAL::IO::read_curve_network(path, curve)) << path;
  return curve;
}

Untangling_result untangled(Network& curve, Untangling_strategy strategy, std::size_t seed)
{
  return untangle(curve, parameters::strategy(strategy).random_seed(seed).number_of_chains(1));
}

void expect_untied(const std::string& path, std::size_t number_of_seeds)
{
  const Network start = read(path);
  for(std::size_t seed = 0; seed < number_of_seeds; ++seed) {
    Network curve = start;
    EXPECT_EQ(untangled(curve, Untangling_strategy::SEARCH, seed).status,
              Untangling_status::UNKNOTTED)
        << path << ", seed " << seed;
    EXPECT_LE(curve.number_of_nodes(), 5u) << path << ", seed " << seed;
  }
}

TEST_F(Long_polygon_search, unties_the_unknots_of_the_paper)
{
  for(const std::string name : {"freedman_he_wang", "goeritz", "thistlethwaite", "ochiai1",
                                "ochiai2", "ochiai3", "ochiai4", "haken"})
    expect_untied((shared_curves::folder() / "paper" / (name + ".obj")).string(), 20);
}

TEST_F(Long_polygon_search, unties_hard_unknots)
{
  for(const Known_curve& known : shared_curves::known_curves({"hard_unknots"}))
    expect_untied(known.path(), known.file.find("PZ120") == std::string::npos ? 20 : 2);
}

TEST_F(Long_polygon_search, brings_every_knot_to_a_tight_shape_of_its_type)
{
  for(const Known_curve& known : shared_curves::known_curves({"knot128", "trefoil100"})) {
    Network curve = read(known.path());
    const Untangling_result result = untangled(curve, Untangling_strategy::AUTO, 0);
    EXPECT_TRUE(result.status == Untangling_status::CONVERGED ||
                result.status == Untangling_status::UNKNOTTED)
        << known.file;
    EXPECT_EQ(knot_test::jones_polynomial(knot_test::diagram_of(knot_test::loops_of(curve))),
              known.jones)
        << known.file;
  }
}

// The flow alone jams on it.
TEST_F(Long_polygon_search, unties_what_the_flow_does_not)
{
  Network curve = read((shared_curves::folder() / "hard_unknots/07_PZ120.obj").string());
  EXPECT_EQ(untangled(curve, Untangling_strategy::AUTO, 0).status, Untangling_status::UNKNOTTED);
}

} // namespace test_long_polygon_search
