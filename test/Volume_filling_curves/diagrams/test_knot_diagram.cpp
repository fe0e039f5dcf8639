// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The public header: diagrams of curves, their codes, and what they prove.

#include "support/refusal_of.h"
#include "support/shared_curves.h"

#include <CGAL/Volume_filling_curves/IO/curve_network.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/identify.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace test_knot_diagram {

namespace VFC = CGAL::Volume_filling_curves;
using VFC::Knottedness;
using VFC::Planar_diagram;
using Curve = VFC::Curve_network_3<>;

Planar_diagram braid(const std::string& word)
{
  return VFC::knot_diagram(
      VFC::make_closed_braid(VFC::parse_braid_word(word), 50 + 20 * word.size(), 0, 1));
}

const std::string left_trefoil = "PD[X[1, 4, 2, 5], X[3, 6, 4, 1], X[5, 2, 6, 3]]";

TEST(Knot_diagram, Codes_of_the_trefoil)
{
  const Planar_diagram diagram = VFC::diagram_of_pd_code(left_trefoil);
  EXPECT_EQ(VFC::pd_code(diagram), left_trefoil);
  EXPECT_EQ(VFC::gauss_code(diagram), "U1-O2-U3-O1-U2-O3-");
  EXPECT_EQ(VFC::dt_code(diagram), "-4 -6 -2");
  EXPECT_EQ(VFC::dt_code(VFC::internal::mirror(diagram)), "4 6 2");
  EXPECT_EQ(VFC::writhe(diagram), -3);
  EXPECT_EQ(VFC::signature(diagram), 2);
  EXPECT_EQ(VFC::determinant(diagram), 3);
}

TEST(Knot_diagram, Other_notations_of_planar_diagram_codes_are_read)
{
  const Planar_diagram diagram = VFC::diagram_of_pd_code(left_trefoil);
  for(const std::string text :
      {"[[1,4,2,5],[3,6,4,1],[5,2,6,3]]", "1 4 2 5 3 6 4 1 5 2 6 3",
       "(0,3,1,4) (2,5,3,0) (4,1,5,2)", "X_{1,4,2,5} X_{3,6,4,1} X_{5,2,6,3}"})
    EXPECT_EQ(VFC::diagram_of_pd_code(text).crossings, diagram.crossings) << text;
  EXPECT_EQ(VFC::diagram_of_pd_code("PD[Loop[1], Loop[2]]").number_of_free_loops, 2u);
}

TEST(Knot_diagram, Codes_are_read_back)
{
  std::vector<Planar_diagram> diagrams{Planar_diagram(), Planar_diagram{{}, 1},
                                       Planar_diagram{{}, 3}};
  for(const std::string word : {"1 1 1", "1 -2 1 -2", "1 1", "1 1 2 2", "1 -2 1 -2 1 -2"})
    diagrams.push_back(braid(word));
  diagrams.push_back({diagrams.back().crossings, 2});
  // a circle on a circle, below, and two loops
  diagrams.push_back({{{0, 2, 1, 3}, {1, 2, 0, 3}}, 0});
  diagrams.push_back(VFC::internal::mirror(diagrams.back()));
  diagrams.push_back({{{0, 1, 1, 0}}, 0});
  diagrams.push_back({{{0, 0, 1, 1}}, 1});
  for(std::uint64_t seed = 0; seed < 30; ++seed) {
    const Curve curve = VFC::make_random_polygon(200, seed);
    diagrams.push_back(VFC::internal::best_diagram(VFC::internal::closed_polygons(curve), 1));
  }
  for(const Planar_diagram& diagram : diagrams) {
    const std::string pd = VFC::pd_code(diagram), gauss = VFC::gauss_code(diagram);
    const Planar_diagram of_pd = VFC::diagram_of_pd_code(pd);
    EXPECT_EQ(of_pd.crossings, diagram.crossings);
    EXPECT_EQ(of_pd.number_of_free_loops, diagram.number_of_free_loops);
    const Planar_diagram of_gauss = VFC::diagram_of_gauss_code(gauss);
    EXPECT_EQ(VFC::gauss_code(of_gauss), gauss);
    EXPECT_EQ(of_gauss.number_of_free_loops, diagram.number_of_free_loops);
    EXPECT_EQ(VFC::signature(of_gauss), VFC::signature(diagram));
    EXPECT_EQ(VFC::determinant(of_gauss), VFC::determinant(diagram));
  }
}

TEST(Knot_diagram, Bad_codes_are_refused_with_a_reason)
{
  const auto pd = [](const std::string& text) {
    return refusal_of([&] { return VFC::diagram_of_pd_code(text); });
  };
  const std::string no_item = " is not part of a planar diagram code",
                    no_crossings = " is not a list of crossings with four arcs each",
                    no_code = "the crossings are no planar diagram code: ";
  EXPECT_EQ(pd("hello"), "'hello'" + no_item);
  EXPECT_EQ(pd("PD[Y[1, 4, 2, 5]]"), "'Y'" + no_item);
  EXPECT_EQ(pd("[1, -4, 2, 5]"), "'-'" + no_item);
  EXPECT_EQ(pd(" \n"), "the planar diagram code is empty");
  EXPECT_EQ(pd("[1, 2, 3]"), "'[1, 2, 3]'" + no_crossings);
  EXPECT_EQ(pd("X[1, 4, 2], X[5, 3, 6, 4, 1]"), "'[1, 4, 2]'" + no_crossings);
  EXPECT_EQ(pd("[1, 1, 2, 2)"), "'[1, 1, 2, 2)'" + no_crossings);
  EXPECT_EQ(pd("PD[X[1, 1, 2, 2]"), "'[' is not closed");
  EXPECT_EQ(pd("X[1, 1, 2, 2]]"), "']' closes a bracket that is not open");
  EXPECT_EQ(pd("1 2 3"), "3 arcs are not four for each crossing");
  EXPECT_EQ(pd("PD[Loop]"), "'[Loop]'" + no_crossings);
  EXPECT_EQ(pd("Loop"), "the last 'Loop' has no number");
  EXPECT_EQ(pd("Loop X[1, 1, 2, 2]"), "'X' stands where a 'Loop' must have its number");
  EXPECT_NE(pd("[1, 2, 3, 99999999999]").find("above"), std::string::npos);
  EXPECT_EQ(pd("[1, 2, 3, 4]"), no_code + "arc 3 is above the last one, arc 2");
  EXPECT_EQ(pd("[0, 0, 1, 0]"), no_code + "arc 0 has more than two ends");
  EXPECT_EQ(pd("[1, 5, 2, 4], [3, 6, 5, 1], [4, 2, 6, 3]"),
            no_code + "the arcs from arc 1 on are not numbered along their component, in the "
                      "direction of its lower strands");
  EXPECT_NE(pd("[1, 3, 2, 4], [2, 4, 3, 1]").find("virtual link"), std::string::npos);
  const auto gauss = [](const std::string& text) {
    return refusal_of([&] { return VFC::diagram_of_gauss_code(text); });
  };
  EXPECT_EQ(gauss("hello"), "'h' is not part of a Gauss code");
  EXPECT_EQ(gauss("O1+U1+ /"), "component 2 of the Gauss code is empty");
  EXPECT_EQ(gauss("/ -"), "component 1 of the Gauss code is empty");
  for(const std::string text : {"--", "O1+U1+-", "-O1+U1+"})
    EXPECT_NE(gauss(text).find("component 1 has passes or a second '-'"), std::string::npos);
  EXPECT_EQ(gauss("O1"), "'O1' is not a pass with a sign, like O1+");
  EXPECT_EQ(gauss("O1+"), "crossing 1 has one pass only");
  EXPECT_EQ(gauss("O1+U1-"), "crossing 1 has two signs");
  EXPECT_EQ(gauss("O1+O1+"), "crossing 1 has two passes on the same level");
  EXPECT_EQ(gauss("O1+X1+"), "'X' is not part of a Gauss code");
  EXPECT_NE(gauss("O1+O2+U1+U2+").find("virtual"), std::string::npos);
  EXPECT_EQ(refusal_of([] {
              return VFC::dt_code({{}, 2});
            }),
            "only a knot has a Dowker-Thistlethwaite code");
  EXPECT_EQ(refusal_of([] {
              return VFC::signature({{{0, 1, 2, 3}}, 0});
            }),
            no_code + "arc 2 is above the last one, arc 1");
}

TEST(Knot_diagram, Knots_are_proved_to_be_knotted_or_not)
{
  EXPECT_EQ(VFC::knottedness(braid("1 2 -3")), Knottedness::UNKNOTTED);
  EXPECT_EQ(VFC::knottedness(braid("1 -1")), Knottedness::UNKNOTTED);
  EXPECT_EQ(VFC::knottedness(braid("1 1 1")), Knottedness::KNOTTED_BY_DETERMINANT);
  EXPECT_EQ(VFC::knottedness(braid("1 2 1 2 1 2 1 2 1 2")), // 10_124, of determinant 1
            Knottedness::KNOTTED_BY_ALEXANDER_POLYNOMIAL);
  EXPECT_EQ(VFC::knottedness(braid("1 1 1 3 3 2 -3 -1 -1 2 -1 -3 -2")), // Kinoshita-Terasaka
            Knottedness::KNOTTED_BY_HOMFLY_POLYNOMIAL);
  EXPECT_EQ(VFC::knottedness(braid("1 1")), Knottedness::LINKED_BY_LINKING_NUMBER);
  EXPECT_EQ(VFC::knottedness(braid("1 -2 1 -2 1 -2")), Knottedness::KNOTTED_BY_DETERMINANT);
  // a trefoil beside a loop has neither determinant nor Alexander polynomial
  EXPECT_EQ(VFC::knottedness(braid("1 1 1 3")), Knottedness::KNOTTED_BY_HOMFLY_POLYNOMIAL);
}

TEST(Knot_diagram, Hard_unknots_are_unknotted)
{
  for(std::uint64_t seed = 0; seed < 20; ++seed)
    EXPECT_EQ(VFC::knottedness(VFC::knot_diagram(VFC::make_hard_unknot(300, 40, seed))),
              Knottedness::UNKNOTTED);
}

TEST(Knot_diagram, Open_curves_have_none)
{
  const Curve arc({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1}, {1, 2}});
  EXPECT_EQ(refusal_of([&] { return VFC::knot_diagram(arc); }),
            "component 0 is not a closed curve, and has no diagram");
}

using Shared_knots = shared_curves::Shared_data_test;

TEST_F(Shared_knots, Are_knotted_for_certain)
{
  for(const auto& known : shared_curves::known_curves({"knot128", "trefoil_hard", "paper"})) {
    Curve curve;
    ASSERT_TRUE(CGAL::IO::read_curve_network(known.path(), curve));
    const Knottedness answer = VFC::knottedness(VFC::knot_diagram(curve));
    EXPECT_NE(answer, Knottedness::UNKNOWN) << known.file;
    EXPECT_EQ(answer == Knottedness::UNKNOTTED, known.type == "0_1") << known.file;
  }
}

} // namespace test_knot_diagram
