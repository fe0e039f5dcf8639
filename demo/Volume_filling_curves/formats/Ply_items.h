// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PLY_ITEMS_H
#define VFC_PLY_ITEMS_H

#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace vfc {

// A type of numbers by its names.
struct Ply_type
{
  enum Kind
  {
    SIGNED,
    UNSIGNED,
    REAL
  };

  std::string_view old_name, name;
  std::size_t size; // in bytes
  Kind kind;
};

// Number, or list of numbers preceded by their count.
struct Ply_property
{
  std::string_view name = {};
  bool is_list = false;
  const Ply_type* type = nullptr;      // null if it is unknown
  const Ply_type* size_type = nullptr; // of the number of numbers of a list
};

struct Ply_element
{
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  // returns the index of a property that is a number, or a list, or none
  std::size_t index(std::string_view property, bool is_list = false) const;

  std::string_view name;
  std::size_t count, line;
  std::vector<Ply_property> properties = {};
};

// PLY file, ASCII or binary: its header, and the items of its elements, one after the other. CGAL's
// reader crashes on headers where a property precedes all elements or has an unexpected type (50
// bytes are enough), refuses files without a reason, reads no edges, and allocates any announced
// size. Linear time.
//
// In ASCII an item may continue in further lines, or share its line with others; an item that does
// both lacks a value, or its predecessor has too many.
class Ply_items
{
public:
  // Reads the header. The text and the defects are borrowed.
  Ply_items(std::string_view text, CGAL::Volume_filling_curves::internal::Defect_list& defects);

  // the elements that the header announces; none if there is an error in it
  const std::vector<Ply_element>& elements() const { return m_elements; }

  // Reads the next item, which belongs to an element. Returns whether it exists; otherwise adds an
  // error to the defects.
  bool next(const Ply_element& element);

  // the lines where the item begins and where the next one is expected, or 0 in a binary file
  std::size_t line() const { return m_is_ascii ? m_line : 0; }
  std::size_t next_line() const { return m_is_ascii ? m_words.line() : 0; }

  // the values of a property of the item: one, or those of a list; a word that is not a number is
  // NaN
  const double* begin(std::size_t property) const { return m_values.data() + m_starts[property]; }
  const double* end(std::size_t property) const { return m_values.data() + m_starts[property + 1]; }

  double value(std::size_t property) const { return *begin(property); }

  // the word in ASCII that the value is
  std::string_view word(std::size_t property) const
  {
    return m_is_ascii ? m_words_of_values[m_starts[property]] : "nan";
  }

  // Adds an error about the item, or about an element.
  void complain(CGAL::Volume_filling_curves::Curve_defect_kind kind, const std::string& message);
  bool refuse(const Ply_element& element,
              CGAL::Volume_filling_curves::Curve_defect_kind kind,
              const std::string& message);

private:
  bool refuse(CGAL::Volume_filling_curves::Curve_defect_kind kind, const std::string& message);
  bool read_header();
  bool read_header_line(std::string_view keyword);
  bool read_format();
  bool read_element();
  bool read_property();
  bool read_type(std::string_view word, const Ply_type*& type);
  bool check_elements();
  bool read(const Ply_property& property);
  bool read(const Ply_type* type, double& value);
  bool end_line();
  std::string item() const;

  CGAL::Volume_filling_curves::internal::Defect_list& m_defects;
  CGAL::Volume_filling_curves::internal::Readable_text m_readable;
  CGAL::Volume_filling_curves::internal::Text_scanner m_words;
  std::string_view m_text, m_bytes; // of a binary file, those not read yet
  bool m_is_ascii = true, m_is_big_endian = false;
  std::vector<Ply_element> m_elements;
  const Ply_element* m_element = nullptr; // of the item
  std::size_t m_number = 0, m_line = 0;   // of the item
  std::vector<double> m_values;
  std::vector<std::string_view> m_words_of_values; // in ASCII
  std::vector<std::size_t> m_starts;               // of the values of each property, and their end
  std::string_view m_word;                         // the last one
  bool m_has_begun = false, m_is_list_too_long = false;
};

} // namespace vfc

#endif // VFC_PLY_ITEMS_H
