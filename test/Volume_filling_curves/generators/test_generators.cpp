// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/knot_invariants.h"
#include "support/refusal_of.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/internal/geometry/elementary_functions.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <locale>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_generators {

namespace vfc = CGAL::Volume_filling_curves;
namespace generators = CGAL::Volume_filling_curves::internal;
using generators::Polygon;
using generators::Polygons;
using generators::Vector;

std::size_t number_of_nodes(const Polygons& polygons)
{
  std::size_t n = 0;
  for(const Polygon& polygon : polygons) n += polygon.size();
  return n;
}

knot_test::Invariants invariants(const Polygons& polygons)
{
  return knot_test::invariants_of(knot_test::loops_of(generators::closed_network(polygons)));
}

// FNV-1a over the bits of all coordinates
std::uint64_t hash(const Polygons& polygons)
{
  std::uint64_t h = 0xcbf29ce484222325u;
  for(const Polygon& polygon : polygons)
    for(const Vector& v : polygon)
      for(int k = 0; k < 3; ++k) {
        const double x = v[k];
        std::uint64_t bits;
        std::memcpy(&bits, &x, sizeof bits);
        h = (h ^ bits) * 0x100000001b3u;
      }
  return h;
}

// The least number of nodes that a generator accepts, by its error message.
template <typename Generate>
std::size_t min_number_of_nodes(const Generate& generate)
{
  try {
    generate(1);
  } catch(const std::invalid_argument& error) {
    const std::string what = error.what();
    return static_cast<std::size_t>(std::stoul(what.substr(what.find("least ") + 6)));
  }
  return 1;
}

TEST(Cos_sin, agrees_with_the_standard_library)
{
  for(int i = -1000; i <= 1000; ++i) {
    const double turns = i / 777.0;
    const auto [c, s] = generators::cos_sin(turns);
    EXPECT_NEAR(c, std::cos(2 * CGAL_PI * turns), 2e-15);
    EXPECT_NEAR(s, std::sin(2 * CGAL_PI * turns), 2e-15);
    EXPECT_NEAR(c * c + s * s, 1, 5e-16);
  }
}

TEST(Cos_sin, is_exact_at_quarter_turns)
{
  EXPECT_EQ(generators::cos_sin(0.25), (std::array<double, 2>{0, 1}));
  EXPECT_EQ(generators::cos_sin(-0.25), (std::array<double, 2>{0, -1}));
  EXPECT_EQ(generators::cos_sin(7.5), (std::array<double, 2>{-1, 0}));
}

TEST(Random_source, is_splitmix64)
{
  generators::Random_source random(1234567); // the published test vector
  EXPECT_EQ(random.bits(), 6457827717110365317u);
  EXPECT_EQ(random.bits(), 3203168211198807973u);
  EXPECT_EQ(random.bits(), 9817491932198370423u);
}

TEST(Generators, give_the_same_bits_everywhere)
{
  EXPECT_EQ(hash(generators::torus_knot(2, 3, 100)), 4944531328873901251u);
  EXPECT_EQ(hash(generators::braid_closure({1, -2, 1, -2}, 100)), 3180050083992913183u);
  EXPECT_EQ(hash(generators::random_polygon(101, 42)), 9834964793269932879u);
  EXPECT_EQ(hash(generators::lattice_polygon(100, 42)), 1941357734964183829u);
  EXPECT_EQ(hash(generators::hard_unknot(100, 500, 1)), 17163753919370850353u);
}

// Functions that users call make networks of these polygons.
TEST(Generators, make_networks)
{
  const auto expect_made_of = [](const Polygons& polygons, const vfc::Curve_network_3<>& network) {
    EXPECT_EQ(network.number_of_components(), polygons.size());
    std::size_t v = 0;
    for(const Polygon& polygon : polygons)
      for(const Vector& point : polygon)
        EXPECT_EQ(generators::to_vector(network.point(v++)), point);
    EXPECT_EQ(v, network.number_of_nodes());
    for(const std::size_t c : network.components()) EXPECT_TRUE(network.is_closed(c));
  };
  expect_made_of(generators::torus_knot(4, 6, 300, 5), vfc::make_torus_knot(4, 6, 300, 5));
  expect_made_of(generators::braid_closure({1, 3}, 300, 5, 6),
                 vfc::make_closed_braid({1, 3}, 300, 5, 6));
  expect_made_of(generators::random_polygon(100, 5), vfc::make_random_polygon(100, 5));
  expect_made_of(generators::lattice_polygon(100, 5), vfc::make_lattice_polygon(100, 5));
  expect_made_of(generators::hard_unknot(100, 500, 5), vfc::make_hard_unknot(100, 500, 5));
  expect_made_of({generators::regular_polygon(7, 2)}, vfc::make_regular_polygon(7, 2));
  EXPECT_EQ(vfc::parse_braid_word("1 -2"), (std::vector<int>{1, -2}));
}

TEST(Generators, make_as_many_nodes_and_components_as_asked_for)
{
  for(std::size_t n : {150u, 151u, 3333u}) {
    EXPECT_EQ(number_of_nodes(generators::torus_knot(3, 4, n)), n);
    EXPECT_EQ(number_of_nodes(generators::torus_knot(4, 6, n)), n);
    EXPECT_EQ(number_of_nodes(generators::braid_closure({1, 3}, n)), n);
    EXPECT_EQ(number_of_nodes(generators::random_polygon(n, 1)), n);
  }
  EXPECT_EQ(generators::torus_knot(4, 6, 300).size(), 2u);
  EXPECT_EQ(generators::braid_closure({1, 3}, 300).size(), 2u);
  EXPECT_EQ(generators::braid_closure({}, 300, 0, 5).size(), 5u);
  EXPECT_EQ(number_of_nodes(generators::lattice_polygon(2000, 1)), 2000u);
}

TEST(Generators, refuse_what_they_cannot_make)
{
  EXPECT_THROW(generators::torus_knot(0, 3, 100), std::invalid_argument);
  EXPECT_THROW(generators::torus_knot(2, 0, 100), std::invalid_argument);
  EXPECT_THROW(generators::torus_knot(2, 3, 5), std::invalid_argument);
  EXPECT_THROW(generators::braid_closure({1, 1, 1}, 10), std::invalid_argument);
  EXPECT_THROW(generators::random_polygon(2, 0), std::invalid_argument);
  EXPECT_THROW(generators::lattice_polygon(7, 0), std::invalid_argument);
  EXPECT_THROW(generators::regular_polygon(2, 1), std::invalid_argument);
  for(const double radius : {0., 5e-324, 9e-151, 1.1e150, std::nan("")})
    EXPECT_THROW(generators::regular_polygon(3, radius), std::invalid_argument) << radius;
  EXPECT_EQ(vfc::make_regular_polygon(1000, 1e-150).number_of_nodes(), 1000u);
}

// Of 100 nodes: on 3 scales, with as many moves on each.
TEST(Hard_unknot, rounds_its_moves_down_to_a_multiple_of_its_scales)
{
  const auto unknot = [](std::size_t moves) {
    return hash(generators::hard_unknot(100, moves, 1));
  };
  EXPECT_EQ(unknot(2), unknot(0));
  EXPECT_EQ(unknot(32), unknot(30));
  EXPECT_NE(unknot(33), unknot(30));
}

TEST(Generators, space_nodes_evenly)
{
  for(const Polygons& polygons :
      {generators::torus_knot(3, 4, 1000), generators::braid_closure({1, -2, 1, -2}, 1000)})
    for(const Polygon& polygon : polygons) {
      const double mean = generators::perimeter(polygon) / static_cast<double>(polygon.size());
      for(std::size_t i = 0; i < polygon.size(); ++i)
        EXPECT_NEAR((polygon[(i + 1) % polygon.size()] - polygon[i]).norm(), mean, 0.02 * mean);
    }
}

TEST(Braid_closure, refuses_letters_that_are_none)
{
  for(const int letter : {0, 1001, -1001, std::numeric_limits<int>::min()})
    EXPECT_THROW(generators::braid_closure({1, letter}, 100), std::invalid_argument) << letter;
}

// At once: nobody could hold the samples of such a braid.
TEST(Braid_closure, refuses_more_strands_than_it_could_have_nodes)
{
  for(const std::size_t strands : {std::size_t(10001), std::numeric_limits<std::size_t>::max()})
    EXPECT_EQ(refusal_of([&] { (void)generators::braid_closure({1}, 100, 0, strands); }),
              "a braid has at most 10000 strands, not " + std::to_string(strands));
}

// At once: nobody could hold the samples of such a knot.
TEST(Torus_knot, refuses_more_turns_than_it_could_have_nodes)
{
  constexpr int most = std::numeric_limits<int>::max();
  for(const auto& [p, q] : {std::pair(1000001, 2), {2, most}, {most, -most - 1}, {2, -10001}})
    EXPECT_THROW(generators::torus_knot(p, q, 100), std::invalid_argument) << p << ' ' << q;
}

TEST(Torus_knot, keeps_its_type_with_the_fewest_nodes)
{
  for(int p = 1; p <= 6; ++p)
    for(int q : {-7, -3, 1, 2, 3, 4, 5, 6, 9}) {
      const std::size_t n = min_number_of_nodes(
          [&](std::size_t nodes) { return generators::torus_knot(p, q, nodes); });
      EXPECT_EQ(invariants(generators::torus_knot(p, q, n)),
                invariants(generators::torus_knot(p, q, 500)))
          << p << ' ' << q << ' ' << n;
    }
}

TEST(Torus_knot, is_turned_by_the_seed_but_stays_the_same)
{
  const Polygons knot = generators::torus_knot(2, 3, 100),
                 turned = generators::torus_knot(2, 3, 100, 9);
  EXPECT_NE(hash(knot), hash(turned));
  EXPECT_NEAR((turned[0][0] - turned[0][50]).norm(), (knot[0][0] - knot[0][50]).norm(), 1e-14);
  EXPECT_EQ(invariants(knot), invariants(turned));
}

TEST(Braid_word, is_read_letter_by_letter)
{
  EXPECT_EQ(generators::parse_braid_word(" 1 -2  13 "), (std::vector<int>{1, -2, 13}));
  EXPECT_TRUE(generators::parse_braid_word("").empty());
}

TEST(Braid_word, does_not_depend_on_the_locale)
{
  struct Grouped : std::numpunct<char>
  {
    char do_thousands_sep() const override { return ','; }
    std::string do_grouping() const override { return "\1"; }
  };
  const std::locale former = std::locale::global(std::locale(std::locale::classic(), new Grouped));
  EXPECT_THROW(generators::parse_braid_word("1,2 3"), std::invalid_argument);
  EXPECT_EQ(generators::parse_braid_word("12 3"), (std::vector<int>{12, 3}));
  std::locale::global(former);
}

TEST(Braid_word, with_a_wrong_letter_is_refused_by_name)
{
  for(const std::string letter : {"0", "x", "1.5", "2x", "99999999999999", "1001", "-"}) try {
      generators::parse_braid_word("1 " + letter + " 2");
      ADD_FAILURE() << letter;
    } catch(const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("'" + letter + "'"), std::string::npos);
    }
}

TEST(Braid_closure, keeps_its_strands_apart)
{
  for(const char* text : {"1 1 1", "1 -2 1 -2", "1 2 3 4 -1 -2 -3", "3", "1 3 2 2 1 3"}) {
    const auto word = generators::parse_braid_word(text);
    const auto curve = vfc::make_closed_braid(word, 2000);
    EXPECT_GT(vfc::min_clearance(curve, 0.45), 0.9) << text;
    EXPECT_GT(vfc::polygonal_thickness(curve), 0.4) << text;
  }
}

TEST(Braid_closure, keeps_its_type_with_the_fewest_nodes)
{
  for(const char* text : {"1 1 1", "1 -2 1 -2", "1 1 -2 1 -2", "1 2 1 2 1 2 1 2", "-1 -1 -1 -1 -1",
                          "1 1 1 2 -1 2", "1 3 2 2 1 3", "1 -2 3 -2 1 -3 -3"}) {
    const auto word = generators::parse_braid_word(text);
    const std::size_t n = min_number_of_nodes(
        [&](std::size_t nodes) { return generators::braid_closure(word, nodes); });
    EXPECT_EQ(invariants(generators::braid_closure(word, n)),
              invariants(generators::braid_closure(word, 800)))
        << text;
  }
}

TEST(Random_polygon, has_edges_of_length_one_and_closes)
{
  for(std::size_t n : {3u, 4u, 5u, 100u, 20001u}) {
    const Polygon polygon = generators::random_polygon(n, 7)[0];
    for(std::size_t i = 0; i < n; ++i)
      EXPECT_NEAR((polygon[(i + 1) % n] - polygon[i]).norm(), 1, 1e-9);
  }
}

// Two million nodes take minutes even without moves.
TEST(Hard_unknot, can_end_while_edges_are_halved)
{
  generators::Run_watch over(0);
  const generators::Watched_scope scope(&over);
  EXPECT_THROW((void)generators::hard_unknot(40, 0, 1), generators::Run_stopped);
}

// For closed equilateral walks the mean squared distance of the nodes 0 and n/2 is n^2/(4(n-1)).
TEST(Random_polygon, has_the_size_of_a_random_one)
{
  constexpr std::size_t n = 40, samples = 4000;
  double sum = 0;
  for(std::size_t seed = 0; seed < samples; ++seed) {
    const Polygon polygon = generators::random_polygon(n, seed)[0];
    sum += (polygon[n / 2] - polygon[0]).squaredNorm();
  }
  EXPECT_NEAR(sum / samples, 1. * n * n / (4 * (n - 1)), 0.35);
}

TEST(Random_polygon, is_embedded_and_depends_on_the_seed)
{
  for(std::uint64_t seed = 1; seed < 10; ++seed) {
    const Polygons polygon = generators::random_polygon(500, seed);
    EXPECT_GT(vfc::min_clearance(generators::closed_network(polygon)), 0);
    EXPECT_NE(hash(polygon), hash(generators::random_polygon(500, seed + 1)));
  }
}

TEST(Lattice_polygon, visits_no_site_twice_and_takes_unit_steps)
{
  const Polygon polygon = generators::lattice_polygon(3000, 3)[0];
  std::set<std::array<double, 3>> sites;
  for(std::size_t i = 0; i < polygon.size(); ++i) {
    sites.insert({polygon[i].x(), polygon[i].y(), polygon[i].z()});
    const Vector step = (polygon[(i + 1) % polygon.size()] - polygon[i]).cwiseAbs();
    EXPECT_EQ(step.x() + step.y() + step.z(), 1);
  }
  EXPECT_EQ(sites.size(), polygon.size());
}

} // namespace test_generators
