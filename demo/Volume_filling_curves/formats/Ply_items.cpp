// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/Ply_items.h"

#include "formats/binary_numbers.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>

namespace vfc {
namespace {

namespace files = CGAL::Volume_filling_curves::internal;
using Kind = CGAL::Volume_filling_curves::Curve_defect_kind;

constexpr Ply_type ply_types[] = {
    {"char", "int8", 1, Ply_type::SIGNED},   {"uchar", "uint8", 1, Ply_type::UNSIGNED},
    {"short", "int16", 2, Ply_type::SIGNED}, {"ushort", "uint16", 2, Ply_type::UNSIGNED},
    {"int", "int32", 4, Ply_type::SIGNED},   {"uint", "uint32", 4, Ply_type::UNSIGNED},
    {"float", "float32", 4, Ply_type::REAL}, {"double", "float64", 8, Ply_type::REAL}};

// Returns the number of a type that bytes, at least as many as it has, begin with.
double binary_number(std::string_view bytes, const Ply_type& type, bool is_big_endian)
{
  const std::uint64_t bits = bits_of(bytes.substr(0, type.size), is_big_endian);
  if(type.kind == Ply_type::REAL)
    return type.size == 4 ? real_of<float>(static_cast<std::uint32_t>(bits))
                          : real_of<double>(bits);
  const std::uint64_t sign = std::uint64_t(1) << (8 * type.size - 1);
  const auto number = static_cast<double>(bits);
  return type.kind == Ply_type::SIGNED && (bits & sign) != 0
             ? number - 2 * static_cast<double>(sign)
             : number;
}

} // namespace

std::size_t Ply_element::index(std::string_view property, bool is_list) const
{
  for(std::size_t i = 0; i < properties.size(); ++i)
    if(properties[i].name == property) return properties[i].is_list == is_list ? i : none;
  return none;
}

Ply_items::Ply_items(std::string_view text, files::Defect_list& defects)
    : m_defects(defects), m_readable(text), m_words(m_readable.text()), m_text(text)
{
  if(!read_header() || !check_elements()) m_elements.clear();
  m_bytes = text.substr(m_readable.text().size() - m_words.rest().size());
}

bool Ply_items::refuse(Kind kind, const std::string& message)
{
  m_defects.add({kind, message, m_words.line()});
  return false;
}

bool Ply_items::refuse(const Ply_element& element, Kind kind, const std::string& message)
{
  m_defects.add({kind, message, element.line});
  return false;
}

void Ply_items::complain(Kind kind, const std::string& message)
{
  m_defects.add({kind, m_is_ascii ? message : item() + ": " + message, line()});
}

bool Ply_items::read_header()
{
  if(m_words.next_word() != "ply") return refuse(Kind::UNKNOWN_FORMAT, "the first word is not ply");
  for(m_words.next_record(); !m_words.is_at_end(); m_words.next_record()) {
    const std::string_view keyword = m_words.next_word();
    if(keyword == "end_header") {
      m_words.next_record();
      return true;
    }
    if(!read_header_line(keyword)) return false;
  }
  return m_readable.is_complete() ? refuse(Kind::WRONG_POINT_COUNT, "the header has no end_header")
                                  : refuse(Kind::BINARY_DATA, m_readable.complaint());
}

bool Ply_items::read_header_line(std::string_view keyword)
{
  if(keyword == "format") return read_format();
  if(keyword == "element") return read_element();
  if(keyword == "property") return read_property();
  if(keyword.empty() || keyword == "comment" || keyword == "obj_info") return true;
  return refuse(Kind::UNKNOWN_FORMAT, files::quoted(keyword) + " does not belong in the header");
}

bool Ply_items::read_format()
{
  const std::string_view word = m_words.next_word();
  m_is_ascii = word == "ascii";
  m_is_big_endian = word == "binary_big_endian";
  return m_is_ascii || m_is_big_endian || word == "binary_little_endian" ||
         refuse(Kind::UNKNOWN_FORMAT, files::quoted(word) + " is no format of PLY");
}

bool Ply_items::read_element()
{
  const std::string_view name = m_words.next_word(), word = m_words.next_word();
  const auto is_same = [&](const Ply_element& element) { return element.name == name; };
  if(std::any_of(m_elements.begin(), m_elements.end(), is_same))
    return refuse(Kind::UNKNOWN_FORMAT, "element " + std::string(name) + " comes twice");
  m_elements.push_back({name, 0, m_words.line()});
  return files::parse_integer(word, m_elements.back().count) ||
         refuse(Kind::UNPARSABLE_NUMBER, files::quoted(word) + " is not a number of items");
}

bool Ply_items::read_property()
{
  if(m_elements.empty()) return refuse(Kind::UNKNOWN_FORMAT, "a property comes before any element");
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

bool Ply_items::read_type(std::string_view word, const Ply_type*& type)
{
  const auto* const found =
      std::find_if(std::begin(ply_types), std::end(ply_types), [&](const Ply_type& known) {
        return word == known.old_name || word == known.name;
      });
  if(found != std::end(ply_types)) type = found;
  return type != nullptr || m_is_ascii || // where its size does not matter
         refuse(Kind::UNKNOWN_FORMAT, files::quoted(word) + " is no type of a property");
}

bool Ply_items::check_elements()
{
  for(const Ply_element& element : m_elements)
    if(element.count > m_text.size())
      return refuse(element, Kind::WRONG_POINT_COUNT, "more is announced than the file can hold");
  if(!m_is_ascii || m_readable.is_complete()) return true;
  while(!m_words.is_at_end()) m_words.next_record();
  return refuse(Kind::BINARY_DATA, m_readable.complaint());
}

bool Ply_items::next(const Ply_element& element)
{
  m_number = m_element == &element ? m_number + 1 : 1;
  m_element = &element;
  m_values.clear();
  m_words_of_values.clear();
  m_starts.assign(1, 0);
  m_has_begun = false;
  for(const Ply_property& property : element.properties) {
    if(!read(property)) {
      if(m_is_list_too_long)
        complain(Kind::BAD_INDEX, "a list is longer than the file");
      else
        m_defects.add({Kind::WRONG_POINT_COUNT,
                       "the file ends within " + item() + " of " + std::to_string(element.count),
                       line()});
      return false;
    }
    m_starts.push_back(m_values.size());
  }
  return !m_is_ascii || end_line();
}

bool Ply_items::read(const Ply_property& property)
{
  double count = 1, value = 0;
  if(property.is_list && !read(property.size_type, count)) return false;
  m_is_list_too_long = !(count >= 0 && count <= static_cast<double>(m_text.size()));
  if(m_is_list_too_long) return false;
  for(double i = 0; i < count; ++i) {
    if(!read(property.type, value)) return false;
    m_values.push_back(value);
    if(m_is_ascii) m_words_of_values.push_back(m_word);
  }
  return true;
}

bool Ply_items::read(const Ply_type* type, double& value)
{
  if(!m_is_ascii) {
    if(m_bytes.size() < type->size) return false;
    value = binary_number(m_bytes, *type, m_is_big_endian);
    m_bytes.remove_prefix(type->size);
    return true;
  }
  for(m_word = m_words.next_word(); m_word.empty() && !m_words.is_at_end();
      m_word = m_words.next_word())
    m_words.next_record();
  if(!m_has_begun) m_line = m_words.line();
  m_has_begun = true;
  if(!files::parse_number(m_word, value)) value = std::numeric_limits<double>::quiet_NaN();
  return !m_word.empty();
}

// Goes to the next line if nothing follows in this one.
bool Ply_items::end_line()
{
  files::Text_scanner rest = m_words;
  if(rest.next_word().empty()) {
    rest.next_record();
    m_words = rest;
  } else if(m_has_begun && m_words.line() != m_line) {
    complain(Kind::MISSING_COORDINATES, item() + " does not end with its line");
    return false;
  }
  return true;
}

std::string Ply_items::item() const
{
  return std::string(m_element->name) + ' ' + std::to_string(m_number);
}

} // namespace vfc
