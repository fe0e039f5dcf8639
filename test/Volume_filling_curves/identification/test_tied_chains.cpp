// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Open chains with a known knot tied in: which knot is found, and where.

#include "support/braid_diagrams.h"

#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/identify.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cstddef>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace test_tied_chains {

namespace VFC = CGAL::Volume_filling_curves;

using namespace knot_test;
using VFC::internal::Vector;
using Point_3 = VFC::Curve_network_3<>::Point_3;

struct Tied_chain
{
  std::vector<Point_3> points;
  std::size_t first, last; // nodes of the knot
};

// The nodes of a closed braid, from the outermost one, where it can be cut.
std::vector<Vector> nodes_of_cut_braid(const Braid& braid, std::size_t number_of_nodes)
{
  const auto curve = VFC::make_closed_braid(braid.word, number_of_nodes);
  std::vector<Vector> nodes;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    nodes.push_back(VFC::internal::to_vector(curve.point(v)));
  const auto is_inner = [](const Vector& a, const Vector& b) { return a.norm() < b.norm(); };
  std::rotate(nodes.begin(), std::max_element(nodes.begin(), nodes.end(), is_inner), nodes.end());
  return nodes;
}

// A tail that leaves a knot: every step leads further outwards, so that it forms no knot itself.
std::vector<Vector> random_tail(const Vector& start,
                                const Vector& outwards,
                                std::size_t number_of_nodes,
                                std::mt19937& random)
{
  const auto number = [&] { return 2 * double(random()) / double(std::mt19937::max()) - 1; };
  std::vector<Vector> tail;
  Vector at = start;
  for(std::size_t v = 0; v < number_of_nodes; ++v) {
    const Vector aside = outwards.cross(Vector(number(), number(), number()));
    tail.push_back(at += outwards + 0.5 * aside);
  }
  return tail;
}

// The tails are on two sides of a plane between the ends of the knot.
Tied_chain tied_chain(const Braid& knot, std::size_t before, std::size_t after, unsigned seed)
{
  constexpr std::size_t nodes_per_letter = 20;
  std::mt19937 random(seed);
  std::vector<Vector> nodes = nodes_of_cut_braid(knot, nodes_per_letter * knot.word.size());
  const Vector outwards = nodes.front().normalized();
  const Vector apart = 0.5 * (nodes.back() - nodes.front()).normalized();
  std::vector<Vector> chain =
      random_tail(nodes.front(), (outwards - apart).normalized(), before, random);
  const std::vector<Vector> end =
      random_tail(nodes.back(), (outwards + apart).normalized(), after, random);
  std::reverse(chain.begin(), chain.end());
  chain.insert(chain.end(), nodes.begin(), nodes.end());
  chain.insert(chain.end(), end.begin(), end.end());
  Tied_chain tied{{}, before, before + nodes.size() - 1};
  for(const Vector& p : chain) tied.points.emplace_back(p.x(), p.y(), p.z());
  return tied;
}

TEST(Long_tied_chains, knots_are_found_where_they_are_tied)
{
  const auto table = prime_knots(VFC_DATA_DIR "/prime_knots.txt");
  unsigned seed = 0;
  for(const std::string name : {"3_1", "3_1*", "4_1", "5_2", "5_2*", "6_1"})
    for(const std::size_t before : {10u, 75u}) {
      const Tied_chain chain = tied_chain(prime_knot(table, name), before, 85 - before, ++seed);
      const VFC::Chain_identity identity =
          VFC::identify_chain(chain.points, VFC::parameters::closures(20).find_core(true));
      EXPECT_EQ(identity.name, name);
      EXPECT_TRUE(identity.knots[0].is_proved);
      ASSERT_EQ(identity.core.size(), 1u);
      // without a tail, the ends of a braid can be pulled back to its first and last crossings
      const auto first = double(identity.core[0].first), last = double(identity.core[0].last);
      const auto begin = double(chain.first), end = double(chain.last), most = (end - begin) / 4;
      EXPECT_NEAR(first, begin + most / 2, most / 2 + 2) << name << ' ' << before;
      EXPECT_NEAR(last, end - most / 2, most / 2 + 2) << name << ' ' << before;
    }
}

#ifdef CGAL_LINKED_WITH_TBB
std::string text(const std::vector<VFC::Chain_section>& sections)
{
  std::ostringstream out;
  for(const VFC::Chain_section& section : sections)
    out << section.first << ' ' << section.last << ' ' << section.name << ' ' << section.share
        << '\n';
  return out.str();
}

std::string text(const VFC::Chain_identity& identity)
{
  std::ostringstream out;
  for(const VFC::Knot_share& knot : identity.knots)
    out << knot.name << ' ' << knot.is_proved << ' ' << knot.count << '\n';
  out << identity.direct.name << '\n' << identity.least_interfering.name << '\n';
  return out.str() + text(identity.core) + text(identity.fingerprint) + text(identity.slipknots);
}

TEST(Long_tied_chains, results_do_not_depend_on_the_number_of_threads)
{
  const auto table = prime_knots(VFC_DATA_DIR "/prime_knots.txt");
  const Tied_chain chain = tied_chain(prime_knot(table, "5_2"), 20, 30, 1);
  const auto parameters = VFC::parameters::closures(30).find_core(true).stride(30);
  const std::string expected = text(VFC::identify_chain(chain.points, parameters));
  EXPECT_NE(expected.find("0_1"), std::string::npos); // several knots, else the test shows little
  for(const std::size_t threads : {1u, 2u}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_EQ(text(VFC::identify_chain<CGAL::Parallel_tag>(chain.points, parameters)), expected);
  }
}
#endif

} // namespace test_tied_chains
