// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_BINARY_PLY_ITEMS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_BINARY_PLY_ITEMS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve_files/Ply_header.h>
#include <CGAL/Volume_filling_curves/internal/text/number_text.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Returns the number of a type that bytes, at least as many as it has, begin with.
inline double binary_ply_number(std::string_view bytes, const Ply_type& type, bool is_big_endian)
{
  std::uint64_t bits = 0;
  for(std::size_t k = 0; k < type.size; ++k) {
    const std::size_t place = is_big_endian ? k : type.size - 1 - k;
    bits = bits << 8 | static_cast<unsigned char>(bytes[place]);
  }
  const auto as = [](auto real, auto pattern) {
    static_assert(sizeof real == sizeof pattern, "the bits of the number");
    std::memcpy(&real, &pattern, sizeof real);
    return static_cast<double>(real);
  };
  if(type.kind == Ply_type::REAL)
    return type.size == 4 ? as(0.f, static_cast<std::uint32_t>(bits)) : as(0., bits);
  const std::uint64_t sign = std::uint64_t(1) << (8 * type.size - 1);
  const auto number = static_cast<double>(bits);
  return type.kind == Ply_type::SIGNED && (bits & sign) != 0
             ? number - 2 * static_cast<double>(sign)
             : number;
}

// Writes the items of a binary PLY file as they stand in one in ASCII, a line for each of them, so
// that there is one reader for both. Every number keeps its value. Linear time.
class Binary_ply_items
{
public:
  // Takes what follows the header.
  Binary_ply_items(std::string_view bytes, bool is_big_endian)
      : m_bytes(bytes), m_is_big_endian(is_big_endian)
  {}

  // returns the items that are there completely
  std::string to_text(const std::vector<Ply_element>& elements)
  {
    std::string text;
    for(const Ply_element& element : elements)
      for(std::size_t i = 0; i < element.count; ++i) {
        const std::size_t size = text.size();
        if(append_item(text, element)) continue;
        text.resize(size);
        return text;
      }
    return text;
  }

private:
  // returns whether there was one
  bool append_item(std::string& text, const Ply_element& element)
  {
    for(const Ply_property& property : element.properties) {
      double count = 1; // of numbers
      if(property.is_list && !append_number(text, *property.size_type, count)) return false;
      for(double k = 0, number; k < count; ++k)
        if(!append_number(text, *property.type, number)) return false;
    }
    text += '\n';
    return !element.properties.empty();
  }

  bool append_number(std::string& text, const Ply_type& type, double& number)
  {
    if(m_bytes.size() < type.size) return false;
    number = binary_ply_number(m_bytes, type, m_is_big_endian);
    m_bytes.remove_prefix(type.size);
    internal::append_number(text, number);
    text += ' ';
    return true;
  }

  std::string_view m_bytes; // what is not read yet
  bool m_is_big_endian;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_BINARY_PLY_ITEMS_H
