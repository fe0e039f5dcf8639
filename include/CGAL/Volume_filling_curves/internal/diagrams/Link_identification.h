// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_LINK_IDENTIFICATION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_LINK_IDENTIFICATION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Homfly_polynomial.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Knot_key.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Knottedness.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Link_identity.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Prime_knot.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/colored_jones_polynomial.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The linking numbers of the components with crossings, in the order of their arcs, and then of
// those without.
inline std::vector<std::vector<int>> linking_matrix(const Planar_diagram& diagram)
{
  const Diagram_strands strands(diagram);
  const std::size_t n = number_of_components(diagram);
  std::vector<std::vector<int>> matrix(n, std::vector<int>(n, 0));
  const auto component = [&](std::size_t arc) {
    std::size_t c = 0;
    while(strands.first_arc(c + 1) <= arc) ++c;
    return c;
  };
  for(std::size_t c = 0; c < diagram.crossings.size(); ++c) {
    const auto& x = diagram.crossings[c];
    const std::size_t lower = component(x[0]), upper = component(x[1]);
    if(lower == upper) continue;
    matrix[lower][upper] += strands.sign(c);
    matrix[upper][lower] += strands.sign(c);
  }
  for(auto& row : matrix)
    for(int& number : row) number /= 2;
  return matrix;
}

// The link of a diagram, by its polynomials. A diagram of at most 10 crossings is one of a knot of
// the classical tables, which Tait, Little and Perko made and Burton (2020) computed again, or of
// a connected sum of some; since their keys differ, equal keys are a proof.
class Link_identification
{
public:
  // \pre the diagram is simplified
  explicit Link_identification(Planar_diagram diagram, Run_watch* watch = nullptr) : m_watch(watch)
  {
    m_identity.diagram = std::move(diagram);
    m_identity.number_of_components = number_of_components(m_identity.diagram);
    m_identity.linking_matrix = linking_matrix(m_identity.diagram);
  }

  // \throws Run_stopped if the watch, if there is one, says so
  Link_identity operator()()
  {
    if(m_identity.number_of_components == 0) return std::move(m_identity);
    m_identity.knottedness = internal::knottedness(m_identity.diagram, m_watch);
    find_polynomials();
    if(m_identity.diagram.crossings.empty())
      name_trivial_link();
    else if(m_identity.number_of_components == 1)
      name_knot();
    return std::move(m_identity);
  }

  // Whether a diagram with fewer crossings may prove a name: of a knot whose polynomials are beyond
  // the limits, or those of a knot of at most 10 crossings.
  bool can_be_proved_by_fewer_crossings() const { return m_can_be_proved; }

private:
  static constexpr std::size_t max_crossings_of_proof = 10; // of the diagram

  void find_polynomials()
  {
    const Planar_diagram& diagram = m_identity.diagram;
    m_homfly = homfly_polynomial(diagram);
    const auto jones = colored_jones_polynomial(diagram, 1);
    std::ostringstream homfly_text, jones_text;
    if(m_homfly) m_homfly->write(homfly_text, {"v", "z"});
    if(jones) jones->write(jones_text, m_identity.number_of_components == 1 ? "t" : "s");
    m_identity.homfly_polynomial = homfly_text.str();
    m_identity.jones_polynomial = jones_text.str();
  }

  void name_trivial_link()
  {
    const std::size_t n = m_identity.number_of_components;
    m_identity.name = n == 1 ? "0_1" : "unlink of " + std::to_string(n) + " components";
    m_identity.is_proved = true;
    m_identity.chirality = Knot_chirality::AMPHICHIRAL;
  }

  void name_knot()
  {
    const std::size_t crossings = m_identity.diagram.crossings.size();
    const auto jones = colored_jones_polynomial(m_identity.diagram, 2);
    m_can_be_proved = !m_homfly || !jones;
    if(m_can_be_proved) return;
    const Knot_key key = Knot_key::of(*m_homfly, *jones);
    auto factors = Prime_factors::of(key, crossings);
    if(!factors) return;
    const Knot_chirality chirality = this->chirality(*factors);
    m_identity.name = knot_name(*factors);
    m_identity.is_proved =
        crossings <= max_crossings_of_proof && chirality != Knot_chirality::UNKNOWN;
    // Polynomials prove that a knot is chiral, never that it is amphichiral.
    if(m_identity.is_proved || chirality == Knot_chirality::CHIRAL)
      m_identity.chirality = chirality;
    if(m_identity.is_proved && factors->empty()) m_identity.knottedness = Knottedness::UNKNOTTED;
    std::size_t least_crossings = 0;
    for(const Prime_knot& knot : *factors) least_crossings += knot.crossings();
    m_can_be_proved = !m_identity.is_proved && least_crossings <= max_crossings_of_proof;
  }

  // Also finds out, for a prime knot with a third key, which of the mirror images it is.
  Knot_chirality chirality(std::vector<Prime_knot>& factors) const
  {
    for(Prime_knot& knot : factors) {
      const Third_knot_key* third = knot.third_key();
      if(!third) continue;
      const auto jones = colored_jones_polynomial(m_identity.diagram, 3);
      if(!jones || factors.size() > 1) return Knot_chirality::UNKNOWN;
      knot.is_mirror = Knot_key::of(*jones) == Knot_key(third->keys[1]);
      if(Knot_key::of(*jones) != Knot_key(third->keys[knot.is_mirror ? 1 : 0]))
        return Knot_chirality::UNKNOWN;
    }
    std::vector<Prime_knot> mirrored;
    for(const Prime_knot& knot : factors) mirrored.push_back(knot.mirrored());
    std::sort(mirrored.begin(), mirrored.end());
    return mirrored == factors ? Knot_chirality::AMPHICHIRAL : Knot_chirality::CHIRAL;
  }

  Run_watch* m_watch; // none if null
  Link_identity m_identity;
  std::optional<Laurent_polynomial_2> m_homfly;
  bool m_can_be_proved = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_LINK_IDENTIFICATION_H
