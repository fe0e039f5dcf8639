// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/Backbones.h"
#include "formats/readers.h"

#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace vfc {
namespace {

namespace files = CGAL::Volume_filling_curves::internal;
using Kind = CGAL::Volume_filling_curves::Curve_defect_kind;

// Reads backbones of the first model in a file of the Protein Data Bank (format 3.3). Fields have
// fixed columns. Residues that are no standard ones count until their chain ends. Linear time.
class Pdb_reader
{
public:
  Pdb_reader(std::string_view text, Junctions junctions)
      : m_readable(text), m_rest(m_readable.text()), m_backbones(junctions)
  {}

  Curve_draft run()
  {
    while(!m_rest.empty() && read_record(next_line())) {
    }
    m_backbones.end_chain();
    Curve_draft& file = m_backbones.draft();
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
      m_backbones.end_chain();
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
    if(m_last_chain != m_chain) m_backbones.end_chain();
    m_chain = m_last_chain;
    const bool is_phosphorus = kind == phosphorus;
    if(!m_backbones.has_open_chain() && is_phosphorus && !is_standard) return; // another molecule
    m_backbones.add({is_phosphorus ? Backbones::Kind::PHOSPHORUS : Backbones::Kind::C_ALPHA,
                     m_chain,
                     columns(line, 23, 27),
                     std::string(m_chain) + ' ' + std::string(field(line, 23, 27)),
                     {field(line, 31, 38), field(line, 39, 46), field(line, 47, 54)},
                     m_line});
  }

  files::Readable_text m_readable;
  std::string_view m_rest; // what is not read yet
  std::size_t m_line = 0;
  Backbones m_backbones;
  std::string_view m_chain, m_last_chain; // of the last atom of a backbone, and of any atom
  std::string m_ended_chains;             // their letters; what follows of them are other molecules
};

} // namespace

Curve_draft read_pdb(std::string_view text, Junctions junctions)
{
  return Pdb_reader(text, junctions).run();
}

} // namespace vfc
