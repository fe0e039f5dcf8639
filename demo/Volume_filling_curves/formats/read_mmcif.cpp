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

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vfc {
namespace {

namespace files = CGAL::Volume_filling_curves::internal;
using Kind = CGAL::Volume_filling_curves::Curve_defect_kind;

// Words of a CIF file (Hall, Allen, Brown 1991; version 1.1): separated by blanks, or in quotes
// that end before a blank, or lines between semicolons at the beginning of a line.
class Cif_scanner
{
public:
  struct Word
  {
    std::string_view text;
    std::size_t line = 0;
    bool is_value = false; // even if it looks like a name

    bool is_end() const { return line == 0; }
    bool is_name() const { return !is_value && !text.empty() && text.front() == '_'; }
    bool is_keyword() const
    {
      return !is_value && (is_end() || text == "loop_" || text == "stop_" || text == "global_" ||
                           text.substr(0, 5) == "data_" || text.substr(0, 5) == "save_");
    }
  };

  explicit Cif_scanner(std::string_view text) : m_text(text) {}

  std::size_t line() const { return m_line; }

  Word next()
  {
    skip_blanks();
    if(m_position == m_text.size()) return {};
    const char c = m_text[m_position];
    if(c == ';' && is_at_line_start()) return lines();
    return c == '\'' || c == '"' ? quoted(c) : plain();
  }

private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

  bool is_at_line_start() const { return m_position == 0 || m_text[m_position - 1] == '\n'; }

  bool is_blank_at(std::size_t i) const { return i >= m_text.size() || is_blank(m_text[i]); }

  void skip_blanks()
  {
    for(bool is_comment = false; m_position < m_text.size(); ++m_position) {
      const char c = m_text[m_position];
      is_comment = c != '\n' && (is_comment || c == '#');
      if(!is_comment && !is_blank(c)) return;
      if(c == '\n') ++m_line;
    }
  }

  Word plain()
  {
    const std::size_t first = m_position;
    while(!is_blank_at(m_position)) ++m_position;
    return {m_text.substr(first, m_position - first), m_line, false};
  }

  // A quote within the word is not followed by a blank: 'O5'' is O5'.
  Word quoted(char quote)
  {
    const std::size_t first = ++m_position;
    while(m_position < m_text.size() && m_text[m_position] != '\n' &&
          !(m_text[m_position] == quote && is_blank_at(m_position + 1)))
      ++m_position;
    const Word word{m_text.substr(first, m_position - first), m_line, true};
    if(m_position < m_text.size() && m_text[m_position] == quote) ++m_position;
    return word;
  }

  Word lines()
  {
    const std::size_t first = m_position + 1, line = m_line;
    const std::size_t end = m_text.find("\n;", first);
    const std::size_t last = end == std::string_view::npos ? m_text.size() : end;
    for(std::size_t i = first; i < last; ++i) m_line += m_text[i] == '\n' ? 1 : 0;
    if(end != std::string_view::npos) ++m_line;
    m_position = end == std::string_view::npos ? m_text.size() : end + 2;
    return {m_text.substr(first, last - first), line, true};
  }

  const std::string_view m_text;
  std::size_t m_position = 0, m_line = 1;
};

// Reads backbones from an mmCIF file (dictionary 5.3) of the Protein Data Bank: the first model in
// the table atom_site. Atoms with a number in their sequence belong to chains; others, such as
// those of calcium, do not. Linear time.
class Mmcif_reader
{
public:
  Mmcif_reader(std::string_view text, Junctions junctions)
      : m_readable(text), m_scanner(m_readable.text()), m_backbones(junctions)
  {}

  Curve_draft run()
  {
    for(Word word = m_scanner.next(); !word.is_end();)
      word = word.text == "loop_" && !word.is_value ? read_loop() : m_scanner.next();
    m_backbones.end_chain();
    Curve_draft& file = m_backbones.draft();
    file.is_complete = m_readable.is_complete();
    if(!file.is_complete)
      file.defects.add({Kind::BINARY_DATA, m_readable.complaint(), m_scanner.line()});
    else if(file.points.empty())
      file.defects.add({Kind::NO_GEOMETRY, missing_text(),
                        m_missing == none ? m_scanner.line() : m_line_of_table});
    return std::move(file);
  }

private:
  using Word = Cif_scanner::Word;

  // Columns: those that are needed, and others.
  enum Column
  {
    ATOM,
    CHAIN,
    RESIDUE,
    X,
    Y,
    Z,
    ELEMENT,
    MODEL,
    AUTHOR_CHAIN,
    AUTHOR_RESIDUE,
    NUMBER_OF_COLUMNS
  };

  static constexpr std::size_t number_of_needed = ELEMENT, none = ~std::size_t(0);

  static std::string_view name_of(std::size_t column)
  {
    constexpr std::string_view names[] = {
        "label_atom_id", "label_asym_id", "label_seq_id",       "Cartn_x",      "Cartn_y",
        "Cartn_z",       "type_symbol",   "pdbx_PDB_model_num", "auth_asym_id", "auth_seq_id"};
    return names[column];
  }

  std::string missing_text() const
  {
    if(m_missing == none) return "there are no C-alpha or P atoms of chains (table atom_site)";
    return "the table atom_site has no column " + std::string(name_of(m_missing));
  }

  // Returns the word behind the loop.
  Word read_loop()
  {
    constexpr std::string_view table = "_atom_site.";
    std::vector<std::size_t> columns(NUMBER_OF_COLUMNS, none);
    std::size_t width = 0;
    bool has_atoms = false;
    Word word = m_scanner.next();
    for(; word.is_name(); word = m_scanner.next(), ++width) {
      if(word.text.substr(0, table.size()) != table) continue;
      if(!has_atoms) m_line_of_table = word.line;
      has_atoms = true;
      for(std::size_t k = 0; k < NUMBER_OF_COLUMNS; ++k)
        if(word.text.substr(table.size()) == name_of(k)) columns[k] = width;
    }
    for(std::size_t k = number_of_needed; has_atoms && k-- > 0;)
      if(columns[k] == none) m_missing = k;
    const bool is_read = has_atoms && m_missing == none;
    std::vector<Word> row;
    for(; !word.is_keyword() && !word.is_name(); word = m_scanner.next()) {
      row.push_back(word);
      if(row.size() < width) continue;
      if(is_read) read_row(row, columns);
      row.clear();
    }
    if(is_read && !row.empty()) // the file ends within it
      m_backbones.draft().defects.add(
          {Kind::UNPARSABLE_NUMBER, "the last row of atom_site is incomplete", row.front().line});
    return word;
  }

  void read_row(const std::vector<Word>& row, const std::vector<std::size_t>& columns)
  {
    const auto at = [&](std::size_t column) {
      return columns[column] == none ? std::string_view() : row[columns[column]].text;
    };
    // Authors' names, which publications use, may differ from those of the dictionary.
    const auto either = [&](std::size_t first, std::size_t second) {
      return at(columns[first] == none ? second : first);
    };
    if(m_model.empty()) m_model = at(MODEL);
    const std::string_view atom = at(ATOM), residue = at(RESIDUE);
    const bool is_c_alpha = atom == "CA" && (at(ELEMENT) == "C" || at(ELEMENT).empty());
    if((!is_c_alpha && atom != "P") || residue == "." || residue == "?" || at(MODEL) != m_model)
      return;
    m_backbones.add({is_c_alpha ? Backbones::Kind::C_ALPHA : Backbones::Kind::PHOSPHORUS,
                     at(CHAIN),
                     residue,
                     std::string(either(AUTHOR_CHAIN, CHAIN)) + ' ' +
                         std::string(either(AUTHOR_RESIDUE, RESIDUE)),
                     {at(X), at(Y), at(Z)},
                     row[columns[X]].line});
  }

  files::Readable_text m_readable;
  Cif_scanner m_scanner;
  Backbones m_backbones;
  std::string_view m_model;     // the first one
  std::size_t m_missing = none; // column
  std::size_t m_line_of_table = 0;
};

} // namespace

Curve_draft read_mmcif(std::string_view text, Junctions junctions)
{
  return Mmcif_reader(text, junctions).run();
}

} // namespace vfc
