// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Names of knots, of diagrams and of curves.

#include "support/braid_diagrams.h"
#include "support/refusal_of.h"

#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/identify.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_identify {

namespace VFC = CGAL::Volume_filling_curves;

using namespace knot_test;
using VFC::Knot_chirality;
using VFC::Link_identity;
using VFC::Planar_diagram;

const std::vector<Named_braid>& knots()
{
  static const std::vector<Named_braid> all = prime_knots(VFC_DATA_DIR "/prime_knots.txt");
  return all;
}

Braid knot(const std::string& name)
{
  return prime_knot(knots(), name);
}

bool is_amphichiral(const std::string& name)
{
  const std::string all = " 4_1 6_3 8_3 8_9 8_12 8_17 8_18 10_17 10_33 10_37 10_43 10_45 10_79 "
                          "10_81 10_88 10_99 10_109 10_115 10_118 10_123 ";
  return all.find(' ' + name + ' ') != std::string::npos;
}

bool is_knotted(const Link_identity& identity)
{
  return identity.knottedness != VFC::Knottedness::UNKNOWN &&
         identity.knottedness != VFC::Knottedness::UNKNOTTED;
}

void expect_identity(const Link_identity& identity, const std::string& name, bool is_mirror)
{
  EXPECT_EQ(identity.name, is_mirror && !is_amphichiral(name) ? name + '*' : name);
  EXPECT_TRUE(identity.is_proved) << name << ' ' << identity.diagram.crossings.size();
  EXPECT_TRUE(is_knotted(identity)) << name;
  EXPECT_EQ(identity.chirality,
            is_amphichiral(name) ? Knot_chirality::AMPHICHIRAL : Knot_chirality::CHIRAL);
}

TEST(Identify, All_prime_knots_up_to_10_crossings_are_named_after_random_moves)
{
  std::mt19937 random(1);
  for(const auto& [name, braid] : knots())
    for(const bool is_mirror : {false, true}) {
      const Braid moved = with_random_moves(is_mirror ? mirrored(braid) : braid, 6, random);
      expect_identity(VFC::identify(closure(moved)), name, is_mirror);
    }
}

TEST(Identify, Curves_of_closed_braids_are_named)
{
  for(std::size_t i = 0; i < knots().size(); i += 10) {
    const auto& [name, braid] = knots()[i];
    const auto curve = VFC::make_closed_braid(braid.word, 400, i);
    expect_identity(VFC::identify(curve), name, false);
  }
}

TEST(Identify, Connected_sums_are_named_by_their_factors)
{
  const auto name_of_sum = [](const Braid& first, const Braid& second) {
    const Link_identity identity = VFC::identify(closure(connected_sum(first, second)));
    EXPECT_TRUE(identity.is_proved);
    return identity.name + ' ' + to_string(identity.chirality);
  };
  const Braid trefoil = knot("3_1");
  EXPECT_EQ(name_of_sum(trefoil, trefoil), "3_1#3_1 chiral");                 // granny knot
  EXPECT_EQ(name_of_sum(trefoil, mirrored(trefoil)), "3_1#3_1* amphichiral"); // square knot
  // the HOMFLY-PT polynomial of 4_1#5_2 is that of 9_12
  EXPECT_EQ(name_of_sum(knot("4_1"), knot("5_2")), "4_1#5_2 chiral");
  EXPECT_EQ(name_of_sum(knot("4_1"), mirrored(knot("5_2"))), "4_1#5_2* chiral");
  EXPECT_EQ(VFC::identify(closure(knot("9_12"))).name, "9_12");
}

TEST(Identify, Knots_with_the_same_homfly_polynomial_have_their_own_names)
{
  const std::vector<std::vector<std::string>> pairs{{"5_1", "10_132"},
                                                    {"8_8", "10_129"},
                                                    {"8_16", "10_156"},
                                                    {"10_25", "10_56"},
                                                    {"10_40", "10_103"}};
  for(const auto& pair : pairs) {
    const Braid first = knot(pair[0]), second = knot(pair[1]);
    const Link_identity one = VFC::identify(closure(first)), other = VFC::identify(closure(second));
    const Link_identity turned = VFC::identify(closure(mirrored(second)));
    EXPECT_TRUE(one.homfly_polynomial == other.homfly_polynomial ||
                one.homfly_polynomial == turned.homfly_polynomial);
    EXPECT_EQ(one.name, pair[0]);
    EXPECT_EQ(other.name, pair[1]);
    EXPECT_EQ(turned.name, pair[1] + '*');
  }
}

TEST(Identify, Unknots_and_unlinks_are_proved)
{
  const Link_identity unknot = VFC::identify(VFC::make_hard_unknot(100, 2000));
  EXPECT_EQ(unknot.name, "0_1");
  EXPECT_TRUE(unknot.is_proved);
  EXPECT_EQ(unknot.knottedness, VFC::Knottedness::UNKNOTTED);
  EXPECT_EQ(unknot.homfly_polynomial, "1");
  const Link_identity unlink = VFC::identify(closure({4, {1, 3, -3}}));
  EXPECT_EQ(unlink.name, "unlink of 3 components");
  EXPECT_TRUE(unlink.is_proved);
  EXPECT_EQ(unlink.knottedness, VFC::Knottedness::UNKNOTTED);
  EXPECT_EQ(VFC::identify(Planar_diagram()).number_of_components, 0u);
}

TEST(Identify, A_crossing_that_was_not_removed_leaves_the_unknot_proved)
{
  const Link_identity kink =
      VFC::internal::Link_identification(Planar_diagram{{{1, 1, 0, 0}}, 0})();
  EXPECT_EQ(kink.name, "0_1");
  EXPECT_TRUE(kink.is_proved);
  EXPECT_EQ(kink.knottedness, VFC::Knottedness::UNKNOTTED);
  EXPECT_EQ(kink.chirality, Knot_chirality::AMPHICHIRAL);
}

TEST(Identify, Links_have_a_linking_matrix_and_polynomials)
{
  const Link_identity hopf = VFC::identify(closure(braid({1, 1})));
  EXPECT_EQ(hopf.number_of_components, 2u);
  EXPECT_EQ(hopf.linking_matrix, (std::vector<std::vector<int>>{{0, 1}, {1, 0}}));
  EXPECT_EQ(hopf.homfly_polynomial, "v z^-1 + v z - v^3 z^-1");
  EXPECT_EQ(hopf.jones_polynomial, "-s - s^5");
  EXPECT_EQ(hopf.knottedness, VFC::Knottedness::LINKED_BY_LINKING_NUMBER);
  EXPECT_EQ(hopf.name, "2^2_1");
  const Link_identity whitehead = VFC::identify(closure(braid({1, -2, 1, -2, -2})));
  EXPECT_EQ(whitehead.linking_matrix, (std::vector<std::vector<int>>{{0, 0}, {0, 0}}));
  EXPECT_TRUE(is_knotted(whitehead));
}

TEST(Identify, All_prime_links_up_to_6_crossings_are_named_after_random_moves)
{
  std::mt19937 random(1);
  for(const auto& [name, word] : prime_knots(VFC_DATA_DIR "/prime_links.txt"))
    for(const bool is_mirror : {false, true}) {
      const bool is_amphichiral = name == "2^2_1" || name == "6^2_2" || name == "6^3_2";
      const auto moved = with_random_moves(is_mirror ? mirrored(word) : word, 10, random);
      const Link_identity identity = VFC::identify(closure(moved));
      EXPECT_EQ(identity.name, is_mirror && !is_amphichiral ? name + '*' : name);
      EXPECT_TRUE(identity.is_proved) << name;
      EXPECT_EQ(identity.chirality,
                is_amphichiral ? Knot_chirality::AMPHICHIRAL : Knot_chirality::CHIRAL);
    }
}

TEST(Identify, Sums_and_other_links_have_no_name)
{
  for(const Braid& link : {braid({1, 1, 2, 2}), braid({1, 1, 2, 2, 2}), braid(Braid_word(8, 1))}) {
    const Link_identity identity = VFC::identify(closure(link));
    EXPECT_EQ(identity.name, "");
    EXPECT_FALSE(identity.is_proved);
  }
}

TEST(Identify, Knots_beyond_the_table_are_knotted_without_a_name)
{
  const Link_identity torus = VFC::identify(closure(braid(Braid_word(11, 1))));
  EXPECT_EQ(torus.name, "");
  EXPECT_FALSE(torus.is_proved);
  EXPECT_TRUE(is_knotted(torus));
}

TEST(Identify, Sums_of_more_than_10_crossings_are_proved_piece_by_piece)
{
  const auto sum = [](const Braid& a, const Braid& b) {
    return VFC::identify(closure(connected_sum(a, b)));
  };
  const Braid septafoil = knot("7_1");
  // 9_42 alone is told from its mirror image by the fourth color
  expect_identity(sum(knot("8_19"), knot("9_42")), "8_19#9_42", false);
  expect_identity(sum(knot("8_19"), mirrored(knot("9_42"))), "8_19#9_42*", false);
  expect_identity(sum(connected_sum(septafoil, septafoil), connected_sum(septafoil, septafoil)),
                  "7_1#7_1#7_1#7_1", false);
  const Link_identity symmetric = sum(knot("4_1"), knot("8_9"));
  EXPECT_EQ(symmetric.name, "4_1#8_9");
  EXPECT_TRUE(symmetric.is_proved);
  EXPECT_EQ(symmetric.chirality, Knot_chirality::AMPHICHIRAL);
}

TEST(Identify, A_name_without_a_proof_proves_no_knot_to_be_amphichiral)
{
  std::mt19937 random(3);
  const auto identity_of_moved = [&](const char* name) {
    for(;;) {
      const Planar_diagram diagram = closure(with_random_moves(knot(name), 9, random));
      const auto pieces = VFC::internal::diagram_pieces(diagram).diagrams;
      if(pieces.size() == 1 && pieces[0].crossings.size() > 10)
        return VFC::internal::Link_identification(diagram)(); // without simplification
    }
  };
  const Link_identity symmetric = identity_of_moved("6_3");
  EXPECT_EQ(symmetric.name, "6_3");
  EXPECT_FALSE(symmetric.is_proved);
  EXPECT_EQ(symmetric.chirality, Knot_chirality::UNKNOWN);
  const Link_identity chiral = identity_of_moved("6_2");
  EXPECT_EQ(chiral.name, "6_2");
  EXPECT_FALSE(chiral.is_proved);
  EXPECT_EQ(chiral.chirality, Knot_chirality::CHIRAL);
}

TEST(Identify, Polylines_are_identified_in_themselves)
{
  const auto curve = VFC::make_torus_knot(2, 3, 60);
  std::vector<VFC::Curve_network_3<>::Point_3> polyline(curve.points().begin(),
                                                        curve.points().end());
  polyline.push_back(polyline.front());
  const std::string name = VFC::identify(curve).name;
  EXPECT_TRUE(name == "3_1" || name == "3_1*");
  EXPECT_EQ(VFC::identify(polyline).name, name);
  polyline.pop_back();
  EXPECT_THROW((void)VFC::identify(polyline), std::invalid_argument); // open
}

TEST(Identify, Codes_that_are_none_are_refused)
{
  EXPECT_THROW((void)VFC::identify(Planar_diagram{{{0, 1, 1, 2}}, 0}), std::invalid_argument);
}

TEST(Identify, A_progress_function_can_interrupt)
{
  const auto stop = [](const VFC::Run_progress&) { return false; };
  EXPECT_THROW((void)VFC::identify(closure(knot("3_1")), VFC::parameters::progress(stop)),
               VFC::Run_interrupted);
}

// Whose polynomials exceed 64 bits.
TEST(Identify, Links_of_many_components_have_no_name)
{
  Planar_diagram diagram = closure(knot("3_1"));
  diagram.number_of_free_loops = 70;
  EXPECT_EQ(VFC::knottedness(diagram), VFC::Knottedness::UNKNOWN);
  const auto identity = VFC::identify(diagram);
  EXPECT_EQ(identity.number_of_components, 71u);
  EXPECT_EQ(identity.name, "");
}

TEST(Identify, Diagrams_of_more_components_than_memory_holds_are_refused)
{
  Planar_diagram diagram = closure(knot("3_1"));
  for(const std::size_t loops : {std::size_t(10000), std::size_t(100000000)}) {
    diagram.number_of_free_loops = loops;
    EXPECT_EQ(refusal_of([&] { return VFC::identify(diagram); }),
              "links of more than 10,000 components are not identified; this one has " +
                  std::to_string(loops + 1));
    EXPECT_EQ(VFC::knottedness(diagram), VFC::Knottedness::UNKNOWN);
    EXPECT_EQ(VFC::determinant(diagram), 0);
  }
  for(const std::size_t loops : {std::size_t(100000001), std::numeric_limits<std::size_t>::max()}) {
    diagram.number_of_free_loops = loops;
    const std::string refusal =
        "a diagram has at most 10^8 components without crossings, not " + std::to_string(loops);
    EXPECT_EQ(refusal_of([&] { return VFC::identify(diagram); }), refusal);
    EXPECT_EQ(refusal_of([&] { return VFC::knottedness(diagram); }), refusal);
    EXPECT_EQ(refusal_of([&] { return VFC::pd_code(diagram); }), refusal);
  }
}

} // namespace test_identify
