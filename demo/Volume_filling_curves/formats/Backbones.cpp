// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/Backbones.h"

#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Polyline_conventions.h>

#include <cmath>
#include <limits>

namespace vfc {

Backbones::Backbones(Junctions junctions)
    : m_polylines(junctions, CGAL::Volume_filling_curves::Closure::OPEN)
{}

void Backbones::add(const Atom& atom)
{
  if(atom.chain != m_chain) end_chain();
  if(!m_atoms.empty() && (atom.residue == m_residue || atom.kind != m_kind)) return;
  m_kind = atom.kind;
  m_chain = atom.chain;
  m_residue = atom.residue;
  Point point;
  point.line = atom.line;
  for(std::size_t k = 0; k < 3; ++k) {
    const std::string_view word = atom.coordinates[k];
    if(CGAL::Volume_filling_curves::internal::parse_number(word, point.point[k])) continue;
    point.unparsable_word = word.empty() ? " " : word;
    point.point[k] = std::numeric_limits<double>::quiet_NaN();
  }
  m_atoms.push_back(point);
  m_residue_names.push_back(atom.residue_name);
}

void Backbones::end_chain()
{
  if(!m_atoms.empty()) {
    warn_of_gaps();
    m_polylines.add(m_atoms, m_atoms.front().line);
  }
  m_atoms.clear();
  m_residue_names.clear();
  m_chain.clear();
}

// C-alpha atoms of neighbors in a chain are 3.8 Angstrom apart, or 2.9; P atoms 5 to 7.5.
double Backbones::longest_step() const
{
  return m_kind == Kind::C_ALPHA ? 4.5 : 8;
}

void Backbones::warn_of_gaps()
{
  const std::size_t first = draft().points.size();
  for(std::size_t i = 1; i < m_atoms.size(); ++i) {
    const auto &p = m_atoms[i - 1].point, &q = m_atoms[i].point;
    if(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) > longest_step())
      draft().defects.add({CGAL::Volume_filling_curves::Curve_defect_kind::CHAIN_GAP,
                           "residues are missing between " + m_residue_names[i - 1] + " and " +
                               m_residue_names[i] + "; a straight edge replaces them",
                           m_atoms[i].line,
                           {Curve_draft::number(first + i - 1), Curve_draft::number(first + i)}});
  }
}

} // namespace vfc
