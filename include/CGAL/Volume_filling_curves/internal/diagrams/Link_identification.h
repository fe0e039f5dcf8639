// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_LINK_IDENTIFICATION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_LINK_IDENTIFICATION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Diagram_pieces.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Homfly_polynomial.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Knot_key.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Knottedness.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Link_identity.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Prime_knot.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Prime_link.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/colored_jones_polynomial.h>

#include <algorithm>
#include <cstddef>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The link of a diagram, by its polynomials. A diagram of at most 10 crossings is one of a knot of
// the classical tables, which Tait, Little and Perko made and Burton (2020) computed again, or of
// a connected sum of some; since their keys differ, equal keys are a proof. So the name of a
// connected sum is proved if each piece of its diagram has at most 10 crossings. Likewise for the
// links of at most 6 crossings (Conway 1970, Rolfsen 1976), which HOMFLY-PT alone distinguishes.
class Link_identification
{
public:
  // \pre the diagram is simplified
  explicit Link_identification(Planar_diagram diagram)
  {
    m_identity.diagram = std::move(diagram);
    m_identity.number_of_components = number_of_components(m_identity.diagram);
    m_identity.linking_matrix = linking_matrix(m_identity.diagram);
  }

  // \throws Run_stopped in a Watched_scope
  Link_identity operator()()
  {
    if(m_identity.number_of_components == 0) return std::move(m_identity);
    m_identity.knottedness = internal::knottedness(m_identity.diagram);
    find_polynomials();
    if(m_identity.diagram.crossings.empty())
      name_trivial_link();
    else if(m_identity.number_of_components == 1)
      name_knot();
    else
      name_link();
    return std::move(m_identity);
  }

  // Whether a diagram with fewer crossings may prove a name: of a knot whose polynomials are beyond
  // the limits, or those of a knot of at most 10 crossings.
  bool can_be_proved_by_fewer_crossings() const { return m_can_be_proved; }

private:
  static constexpr std::size_t max_crossings_of_proof = 10; // of a piece

  void find_polynomials()
  {
    const Planar_diagram& diagram = m_identity.diagram;
    m_homfly = homfly_polynomial(diagram);
    const auto jones = colored_jones_polynomial(diagram, 1);
    std::ostringstream homfly_text, jones_text;
    for(std::ostringstream* text : {&homfly_text, &jones_text}) text->imbue(std::locale::classic());
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

  // The knot is the sum of its diagram's pieces, each of which may have a name.
  void name_knot()
  {
    std::vector<Prime_knot> factors;
    bool are_named = true, are_oriented = true, are_proved = true;
    for(const Planar_diagram& piece : diagram_pieces(m_identity.diagram).diagrams) {
      const Piece_name name = piece_name(piece);
      are_named = are_named && name.is_known;
      are_oriented = are_oriented && name.is_oriented;
      are_proved = are_proved && name.is_proved;
      factors.insert(factors.end(), name.factors.begin(), name.factors.end());
    }
    if(!are_named) return;
    std::sort(factors.begin(), factors.end());
    m_identity.name = knot_name(factors);
    m_identity.is_proved = are_proved;
    // Polynomials prove that a knot is chiral, never that it is amphichiral.
    const bool is_chiral = mirrored(factors) != factors;
    if(is_chiral && are_oriented)
      m_identity.chirality = Knot_chirality::CHIRAL;
    else if(!is_chiral && are_proved)
      m_identity.chirality = Knot_chirality::AMPHICHIRAL;
    if(are_proved && factors.empty()) m_identity.knottedness = Knottedness::UNKNOTTED;
  }

  // A prime link by its polynomial. Only a proved name tells whether it is chiral: a link may have
  // the polynomial of a chiral one for some orientations of its components, and not for others.
  void name_link()
  {
    const std::size_t crossings = m_identity.diagram.crossings.size();
    const auto pieces = diagram_pieces(m_identity.diagram);
    if(!m_homfly || pieces.diagrams.size() > 1 || pieces.number_of_splits > 0) return;
    const auto link = Prime_link::of(Knot_key::of(*m_homfly));
    if(!link || link->components != m_identity.number_of_components || link->crossings > crossings)
      return;
    m_identity.name = link->name();
    m_identity.is_proved = crossings <= Prime_link::max_crossings;
    if(m_identity.is_proved)
      m_identity.chirality =
          link->is_amphichiral() ? Knot_chirality::AMPHICHIRAL : Knot_chirality::CHIRAL;
    else
      m_can_be_proved = true;
  }

  struct Piece_name
  {
    std::vector<Prime_knot> factors;
    bool is_known = false;
    bool is_oriented = false; // no factor may as well be its mirror image
    bool is_proved = false;
  };

  Piece_name piece_name(const Planar_diagram& piece)
  {
    const auto homfly = homfly_polynomial(piece);
    const auto jones = colored_jones_polynomial(piece, 2);
    const std::size_t crossings = piece.crossings.size();
    if(!homfly || !jones) {
      m_can_be_proved = true;
      return {};
    }
    auto factors = Prime_factors::of(Knot_key::of(*homfly, *jones), crossings);
    if(!factors) return {};
    const bool is_oriented = find_mirror_image(*factors, piece);
    const bool is_proved = is_oriented && crossings <= max_crossings_of_proof;
    std::size_t min_crossings = 0;
    for(const Prime_knot& knot : *factors) min_crossings += knot.crossings();
    if(!is_proved && min_crossings <= max_crossings_of_proof) m_can_be_proved = true;
    return {std::move(*factors), true, is_oriented, is_proved};
  }

  // Finds out, for a prime knot with a third key, which of the mirror images it is; returns whether
  // that is known of all factors.
  bool find_mirror_image(std::vector<Prime_knot>& factors, const Planar_diagram& piece) const
  {
    for(Prime_knot& knot : factors) {
      const Third_knot_key* third = knot.third_key();
      if(!third) continue;
      const auto jones = colored_jones_polynomial(piece, 3);
      if(!jones || factors.size() > 1) return false;
      knot.is_mirror = Knot_key::of(*jones) == Knot_key(third->keys[1]);
      if(Knot_key::of(*jones) != Knot_key(third->keys[knot.is_mirror ? 1 : 0])) return false;
    }
    return true;
  }

  Link_identity m_identity;
  std::optional<Laurent_polynomial_2> m_homfly;
  bool m_can_be_proved = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_LINK_IDENTIFICATION_H
