// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_PLANAR_DIAGRAMS_H
#define VFC_TEST_PLANAR_DIAGRAMS_H

#include "support/knot_diagram.h"

#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/diagram_of_curve.h>

#include <cstddef>
#include <string>

// Test support: planar diagrams in the form that the independent invariants take.
namespace knot_test {

using CGAL::Volume_filling_curves::Planar_diagram;

inline Diagram plain_diagram(const Planar_diagram& diagram)
{
  const CGAL::Volume_filling_curves::internal::Diagram_strands strands(diagram);
  Diagram result;
  result.number_of_pieces = 2 * diagram.crossings.size();
  result.number_of_components = strands.number_of_components() + diagram.number_of_free_loops;
  const auto component = [&](std::size_t arc) {
    std::size_t c = 0;
    while(strands.first_arc(c + 1) <= arc) ++c;
    return c;
  };
  for(std::size_t c = 0; c < diagram.crossings.size(); ++c) {
    const auto& x = diagram.crossings[c];
    const int sign = strands.sign(c);
    result.crossings.push_back({sign, x[sign > 0 ? 3 : 1], x[sign > 0 ? 1 : 3], x[0], x[2],
                                component(x[1]), component(x[0])});
  }
  return result;
}

// The diagram of a closed braid, seen from a direction in which it has many crossings.
inline Planar_diagram braid_diagram(const std::string& word, std::size_t direction = 0)
{
  namespace VFC = CGAL::Volume_filling_curves;
  const auto curve =
      VFC::make_closed_braid(VFC::parse_braid_word(word), 50 + 20 * word.size(), 0, 1);
  const auto polygons = VFC::internal::closed_polygons(curve);
  return *VFC::internal::Polygon_projection(polygons,
                                            VFC::internal::viewing_direction(direction))();
}

} // namespace knot_test

#endif // VFC_TEST_PLANAR_DIAGRAMS_H
