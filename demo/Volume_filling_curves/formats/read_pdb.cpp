// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/readers.h"

#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Polylines_to_curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Polyline_conventions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vfc {
namespace {

namespace files = CGAL::Volume_filling_curves::internal;
using CGAL::Volume_filling_curves::Closure;
using Kind = CGAL::Volume_filling_curves::Curve_defect_kind;

// Reads backbones from a file of the Protein Data Bank (format 3.3): for each chain of the first
// model an arc through the C-alpha atoms of a protein, or the P atoms of RNA and DNA. The first
// atom of either kind decides, since proteins may hold phosphorus. Fields have fixed columns. Of a
// residue with alternate locations the first is taken; residues that are no standard ones count
// until their chain ends. Coordinates are in Angstrom. Linear time.
class Pdb_reader
{
public:
  Pdb_reader(std::string_view text, Junctions junctions)
      : m_readable(text), m_rest(m_readable.text()), m_polylines(junctions, Closure::OPEN)
  {}

  Curve_draft run()
  {
    while(!m_rest.empty() && read_record(next_line())) {
    }
    end_chain();
    Curve_draft& file = m_polylines.draft();
    file.is_complete = m_readable.is_complete();
    if(!file.is_complete)
      file.defects.add({Kind::BINARY_DATA, m_readable.complaint(), m_line + 1});
    else if(file.points.empty())
      file.defects.add(
          {Kind::NO_GEOMETRY, "there are no C-alpha or P atoms (records ATOM)", m_line});
    return std::move(file);
  }

private:
  static constexpr std::string_view c_alpha = " CA ", phosphorus = " P  ";

  // C-alpha atoms of neighbors in a chain are 3.8 Angstrom apart, or 2.9; P atoms 5 to 7.5.
  double longest_step() const { return m_kind == c_alpha ? 4.5 : 8; }

  std::string_view next_line()
  {
    ++m_line;
    const std::size_t end = (std::min)(m_rest.find('\n'), m_rest.size());
    std::string_view line = m_rest.substr(0, end);
    m_rest.remove_prefix((std::min)(end + 1, m_rest.size()));
    if(!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }

  // the columns first to last, counted from 1
  static std::string_view columns(std::string_view line, std::size_t first, std::size_t last)
  {
    return line.substr((std::min)(first - 1, line.size()), last - first + 1);
  }

  // the same, without surrounding blanks
  static std::string_view field(std::string_view line, std::size_t first, std::size_t last)
  {
    const std::string_view text = columns(line, first, last);
    const std::size_t begin = text.find_first_not_of(' ');
    if(begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
  }

  // Returns whether there is more to read.
  bool read_record(std::string_view line)
  {
    const std::string_view name = field(line, 1, 6);
    if(name == "ENDMDL" || name == "END") return false;
    if(name == "TER") {
      m_ended_chains += m_last_chain;
      end_chain();
    }
    const bool is_standard = name == "ATOM";
    if(!is_standard && name != "HETATM") return true;
    m_last_chain = columns(line, 22, 22);
    const bool is_behind_chain = m_ended_chains.find(m_last_chain) != std::string::npos;
    const std::string_view kind = columns(line, 13, 16);
    if((kind == c_alpha || kind == phosphorus) && (is_standard || !is_behind_chain))
      add_atom(line, kind, is_standard);
    return true;
  }

  void add_atom(std::string_view line, std::string_view kind, bool is_standard)
  {
    const std::string_view chain = m_last_chain, residue = columns(line, 23, 27);
    if(chain != m_chain) end_chain();
    if(m_atoms.empty() && kind == phosphorus && !is_standard) return;        // of another molecule
    if(!m_atoms.empty() && (residue == m_residue || kind != m_kind)) return; // elsewhere, or aside
    m_kind = kind;
    m_chain = chain;
    m_residue = residue;
    files::Polylines_to_curve_draft::Point atom;
    atom.line = m_line;
    const std::string_view words[] = {field(line, 31, 38), field(line, 39, 46),
                                      field(line, 47, 54)};
    for(std::size_t k = 0; k < 3; ++k) {
      if(files::parse_number(words[k], atom.point[k])) continue;
      atom.unparsable_word = words[k].empty() ? " " : words[k];
      atom.point[k] = std::numeric_limits<double>::quiet_NaN();
    }
    m_atoms.push_back(atom);
  }

  void end_chain()
  {
    if(!m_atoms.empty()) {
      warn_of_gaps();
      m_polylines.add(m_atoms, m_atoms.front().line);
    }
    m_atoms.clear();
    m_chain = {};
  }

  void warn_of_gaps()
  {
    const std::size_t first = m_polylines.draft().points.size();
    for(std::size_t i = 1; i < m_atoms.size(); ++i) {
      const auto &p = m_atoms[i - 1].point, &q = m_atoms[i].point;
      if(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) > longest_step())
        m_polylines.draft().defects.add(
            {Kind::CHAIN_GAP,
             "residues are missing in a chain; a straight edge replaces them",
             m_atoms[i].line,
             {Curve_draft::number(first + i - 1), Curve_draft::number(first + i)}});
    }
  }

  files::Readable_text m_readable;
  std::string_view m_rest; // what is not read yet
  std::size_t m_line = 0;
  files::Polylines_to_curve_draft m_polylines;
  std::vector<files::Polylines_to_curve_draft::Point> m_atoms; // of the chain
  std::string_view m_kind, m_chain, m_residue, m_last_chain;   // the last one of any atom
  std::string m_ended_chains; // their letters; what follows of them are other molecules
};

} // namespace

Curve_draft read_pdb(std::string_view text, Junctions junctions)
{
  return Pdb_reader(text, junctions).run();
}

} // namespace vfc
