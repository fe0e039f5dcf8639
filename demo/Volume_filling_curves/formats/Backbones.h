// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_BACKBONES_H
#define VFC_BACKBONES_H

#include "formats/readers.h"

#include <CGAL/Volume_filling_curves/internal/curve_files/Polylines_to_curve_draft.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace vfc {

// Collects the backbones of the chains of a structure: for each chain an arc through the C-alpha
// atoms of a protein, or the P atoms of RNA and DNA. The first atom of either kind decides, since
// proteins may hold phosphorus. Of a residue with alternate locations the first is taken.
// Coordinates are in Angstrom.
class Backbones
{
public:
  enum class Kind
  {
    C_ALPHA,
    PHOSPHORUS
  };

  struct Atom
  {
    Kind kind;
    std::string_view chain, residue; // the residue distinguishes itself from its neighbors only
    std::string residue_name;        // for humans, such as "A 12"
    std::array<std::string_view, 3> coordinates;
    std::size_t line;
  };

  explicit Backbones(Junctions junctions);

  bool has_open_chain() const { return !m_atoms.empty(); }

  // Adds an atom to its chain; another chain begins with the first atom of it.
  void add(const Atom& atom);
  void end_chain();

  Curve_draft& draft() { return m_polylines.draft(); }

private:
  using Point = CGAL::Volume_filling_curves::internal::Polylines_to_curve_draft::Point;

  double longest_step() const;
  void warn_of_gaps();

  CGAL::Volume_filling_curves::internal::Polylines_to_curve_draft m_polylines;
  std::vector<Point> m_atoms; // of the chain
  std::vector<std::string> m_residue_names;
  Kind m_kind = Kind::C_ALPHA;
  std::string m_chain, m_residue;
};

} // namespace vfc

#endif // VFC_BACKBONES_H
