// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Planar diagram codes: what is one, and how its strands run.

#include <CGAL/Volume_filling_curves/internal/diagrams/is_planar_diagram.h>

#include <gtest/gtest.h>

namespace test_planar_diagram {

namespace VFC = CGAL::Volume_filling_curves;

using VFC::Planar_diagram;
using namespace VFC::internal;

// the trefoil 3_1 of KnotTheory, which is left-handed
const Planar_diagram trefoil{{{0, 3, 1, 4}, {2, 5, 3, 0}, {4, 1, 5, 2}}, 0};
const Planar_diagram figure_eight{{{3, 1, 4, 0}, {7, 5, 0, 4}, {5, 2, 6, 3}, {1, 6, 2, 7}}, 0};
const Planar_diagram hopf_link{{{3, 0, 2, 1}, {1, 2, 0, 3}}, 0};
// the loops of Reidemeister's first move, of either sign
const Planar_diagram negative_loop{{{0, 1, 1, 0}}, 0};
const Planar_diagram positive_loop{{{0, 0, 1, 1}}, 0};
// a circle that lies on another one
const Planar_diagram circle_on_circle{{{0, 2, 1, 3}, {1, 2, 0, 3}}, 0};

TEST(Planar_diagram, Valid_codes_are_accepted)
{
  for(const auto& diagram : {trefoil, figure_eight, hopf_link, negative_loop, positive_loop,
                             circle_on_circle, Planar_diagram()})
    EXPECT_TRUE(is_planar_diagram(diagram));
}

TEST(Planar_diagram, Codes_that_are_none_are_refused)
{
  const Planar_diagram no_such_arc{{{0, 1, 1, 2}}, 0};
  const Planar_diagram third_end{{{0, 0, 1, 0}}, 0};
  const Planar_diagram against_lower_strand{{{0, 3, 5, 4}, {2, 5, 3, 0}, {4, 1, 1, 2}}, 0};
  const Planar_diagram virtual_trefoil{{{0, 2, 1, 3}, {1, 3, 2, 0}}, 0};
  const Planar_diagram out_of_order{{{0, 4, 1, 3}, {2, 5, 4, 0}, {3, 1, 5, 2}}, 0};
  for(const auto& diagram :
      {no_such_arc, third_end, against_lower_strand, virtual_trefoil, out_of_order})
    EXPECT_FALSE(is_planar_diagram(diagram));
}

TEST(Planar_diagram, Signs_follow_from_the_order_of_the_arcs)
{
  EXPECT_EQ(VFC::internal::writhe(trefoil), -3);
  EXPECT_EQ(VFC::internal::writhe(figure_eight), 0);
  EXPECT_EQ(std::abs(VFC::internal::writhe(hopf_link)), 2);
  EXPECT_EQ(VFC::internal::writhe(negative_loop), -1);
  EXPECT_EQ(VFC::internal::writhe(positive_loop), 1);
  EXPECT_EQ(VFC::internal::writhe(circle_on_circle), 0);
}

TEST(Planar_diagram, Components_include_free_loops)
{
  EXPECT_EQ(number_of_components(trefoil), 1u);
  EXPECT_EQ(number_of_components(hopf_link), 2u);
  EXPECT_EQ(number_of_components(Planar_diagram{{}, 3}), 3u);
}

TEST(Planar_diagram, Arcs_lead_from_crossing_to_crossing)
{
  for(const auto& diagram :
      {trefoil, figure_eight, hopf_link, negative_loop, positive_loop, circle_on_circle}) {
    const Diagram_strands strands(diagram);
    for(std::size_t arc = 0; arc < 2 * diagram.crossings.size(); ++arc) {
      const auto target = strands.target(arc), source = strands.source(strands.next(arc));
      EXPECT_EQ(diagram.crossings[target.crossing][target.k], arc);
      EXPECT_EQ(source.crossing, target.crossing);
      EXPECT_EQ(source.k, (target.k + 2) % 4);
    }
  }
}

TEST(Planar_diagram, Mirror_images_have_opposite_signs)
{
  for(const auto& diagram : {trefoil, figure_eight, hopf_link, negative_loop, positive_loop}) {
    const Planar_diagram image = mirror(diagram);
    EXPECT_TRUE(is_planar_diagram(image));
    EXPECT_EQ(VFC::internal::writhe(image), -VFC::internal::writhe(diagram));
    EXPECT_EQ(mirror(image).crossings, diagram.crossings);
  }
}

} // namespace test_planar_diagram
