// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_PLY_HEADER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_PLY_HEADER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

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

  // returns null if there is no such type
  static const Ply_type* of(std::string_view name)
  {
    static constexpr Ply_type types[] = {
        {"char", "int8", 1, SIGNED},   {"uchar", "uint8", 1, UNSIGNED},
        {"short", "int16", 2, SIGNED}, {"ushort", "uint16", 2, UNSIGNED},
        {"int", "int32", 4, SIGNED},   {"uint", "uint32", 4, UNSIGNED},
        {"float", "float32", 4, REAL}, {"double", "float64", 8, REAL}};
    const auto found = std::find_if(std::begin(types), std::end(types), [&](const Ply_type& type) {
      return name == type.old_name || name == type.name;
    });
    return found == std::end(types) ? nullptr : found;
  }
};

// A number, or a list of numbers behind their number.
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

  std::string_view name;
  std::size_t count, line;
  std::vector<Ply_property> properties = {};

  // whether the places of numbers are not known
  bool has_list() const
  {
    return std::any_of(properties.begin(), properties.end(),
                       [](const Ply_property& property) { return property.is_list; });
  }

  std::size_t place(std::string_view property) const
  {
    const auto found = std::find_if(properties.begin(), properties.end(),
                                    [&](const Ply_property& p) { return p.name == property; });
    return found == properties.end() ? none : static_cast<std::size_t>(found - properties.begin());
  }
};

enum class Ply_format
{
  ASCII,
  BINARY_LITTLE_ENDIAN,
  BINARY_BIG_ENDIAN
};

// The header of a PLY file: the format of what follows, and the elements with their numbers and
// properties.
class Ply_header
{
public:
  // Reads the header, and the end of its last line. What is wrong goes to the file, but not that
  // the header has no end if the text has not all of it.
  Ply_header(Text_scanner& words, bool is_whole_text, Curve_draft& file)
      : m_words(words), m_is_whole_text(is_whole_text), m_file(file)
  {
    m_is_complete = read();
  }

  // returns whether all of it was understood
  bool is_complete() const { return m_is_complete; }

  Ply_format format() const { return m_format; }
  const std::vector<Ply_element>& elements() const { return m_elements; }

private:
  bool refuse(Curve_defect_kind kind, const std::string& message)
  {
    m_file.defects.add({kind, message, m_words.line()});
    return false;
  }

  bool read()
  {
    if(m_words.next_word() != "ply")
      return refuse(Curve_defect_kind::UNKNOWN_FORMAT, "the first word is not ply");
    for(m_words.next_record(); !m_words.is_at_end(); m_words.next_record()) {
      const std::string_view keyword = m_words.next_word();
      if(keyword == "end_header") {
        m_words.next_record();
        return true;
      }
      if(!read_line(keyword)) return false;
    }
    return m_is_whole_text &&
           refuse(Curve_defect_kind::WRONG_POINT_COUNT, "the header has no end_header");
  }

  bool read_line(std::string_view keyword)
  {
    if(keyword == "format") return read_format();
    if(keyword == "element") return read_element();
    if(keyword == "property") return read_property();
    if(keyword.empty() || keyword == "comment" || keyword == "obj_info") return true;
    return refuse(Curve_defect_kind::UNKNOWN_FORMAT,
                  quoted(keyword) + " does not belong in the header");
  }

  bool read_format()
  {
    static constexpr std::array<std::string_view, 3> names = {"ascii", "binary_little_endian",
                                                              "binary_big_endian"};
    const std::string_view word = m_words.next_word();
    const auto found = std::find(names.begin(), names.end(), word);
    m_format = static_cast<Ply_format>(found - names.begin());
    return found != names.end() ||
           refuse(Curve_defect_kind::UNKNOWN_FORMAT, quoted(word) + " is no format of PLY");
  }

  bool read_element()
  {
    const std::string_view name = m_words.next_word(), word = m_words.next_word();
    m_elements.push_back({name, 0, m_words.line()});
    return parse_integer(word, m_elements.back().count) ||
           refuse(Curve_defect_kind::UNPARSABLE_NUMBER, quoted(word) + " is not a number of items");
  }

  bool read_property()
  {
    if(m_elements.empty())
      return refuse(Curve_defect_kind::UNKNOWN_FORMAT, "a property comes before any element");
    const auto read_type = [&](std::string_view word, const Ply_type*& type) {
      type = Ply_type::of(word);
      return type != nullptr || m_format == Ply_format::ASCII || // where its size does not matter
             refuse(Curve_defect_kind::UNKNOWN_FORMAT, quoted(word) + " is no type of a property");
    };
    Ply_property property;
    std::string_view word = m_words.next_word();
    if(word == "list") {
      property.is_list = true;
      if(!read_type(m_words.next_word(), property.size_type)) return false;
      word = m_words.next_word();
    }
    if(!read_type(word, property.type)) return false;
    property.name = m_words.next_word();
    m_elements.back().properties.push_back(property);
    return true;
  }

  Text_scanner& m_words;
  bool m_is_whole_text;
  Curve_draft& m_file;
  bool m_is_complete = false;
  Ply_format m_format = Ply_format::ASCII;
  std::vector<Ply_element> m_elements;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_PLY_HEADER_H
