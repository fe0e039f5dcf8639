// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/mesh_text.h"

#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <sstream>

namespace vfc {
namespace {

std::size_t size_of_type(const std::string& type)
{
  if(type == "char" || type == "uchar" || type == "int8" || type == "uint8") return 1;
  if(type == "short" || type == "ushort" || type == "int16" || type == "uint16") return 2;
  return type == "double" || type == "float64" ? 8 : 4;
}

// Skips all that the header of a PLY file announces, number by number.
class Ply_text
{
public:
  explicit Ply_text(std::string_view text) : m_text(text) {}

  std::vector<Text_problem> problems()
  {
    if(!read_header()) return {};
    for(const Element& element : m_elements) {
      if(element.count > m_text.size())
        return {{"truncated file", "more is announced than the file can hold", 0, true}};
      for(std::size_t i = 0; i < element.count; ++i)
        for(const Property& property : element.properties)
          if(!skip(property)) return {problem(element, i)};
    }
    return {};
  }

private:
  struct Property
  {
    std::size_t size, size_of_count; // in bytes; the latter is 0 unless it is a list
  };

  struct Element
  {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties = {};
  };

  bool read_header()
  {
    while(m_place < m_text.size()) {
      const std::size_t end = (std::min)(m_text.find('\n', m_place), m_text.size());
      std::istringstream words(std::string(m_text.substr(m_place, end - m_place)));
      m_place = (std::min)(end + 1, m_text.size());
      std::string word, type, type_of_list;
      words >> word;
      if(word == "end_header") return true;
      if(word == "format") words >> m_format;
      if(word == "element") {
        m_elements.emplace_back();
        words >> m_elements.back().name >> m_elements.back().count;
      }
      if(word == "property" && !m_elements.empty() && words >> type) {
        const bool is_list = type == "list" && words >> type >> type_of_list;
        m_elements.back().properties.push_back(
            {size_of_type(is_list ? type_of_list : type), is_list ? size_of_type(type) : 0});
      }
    }
    return false;
  }

  // returns whether the file has the property
  bool skip(const Property& property)
  {
    if(property.size_of_count == 0) return skip_numbers(1, property.size);
    const std::optional<std::uint64_t> count = read_count(property.size_of_count);
    m_is_too_long = count && *count > m_text.size();
    return count && !m_is_too_long && skip_numbers(*count, property.size);
  }

  bool skip_numbers(std::size_t count, std::size_t size)
  {
    if(m_format == "ascii") {
      for(; count > 0; --count)
        if(next_word().empty()) return false;
      return true;
    }
    if(count * size > m_text.size() - m_place) return false;
    m_place += count * size;
    return true;
  }

  std::optional<std::uint64_t> read_count(std::size_t size)
  {
    if(m_format == "ascii") {
      const std::string word(next_word());
      if(word.empty()) return std::nullopt;
      return std::strtoull(word.c_str(), nullptr, 10); // also of "-1": too many
    }
    const std::size_t place = m_place;
    if(!skip_numbers(1, size)) return std::nullopt;
    std::uint64_t count = 0;
    for(std::size_t i = 0; i < size; ++i) {
      const std::size_t byte = m_format == "binary_big_endian" ? i : size - 1 - i;
      count = count << 8 | static_cast<unsigned char>(m_text[place + byte]);
    }
    return count;
  }

  std::string_view next_word()
  {
    const auto is_blank = [&] { return std::isspace(static_cast<unsigned char>(m_text[m_place])); };
    while(m_place < m_text.size() && is_blank()) ++m_place;
    const std::size_t first = m_place;
    while(m_place < m_text.size() && !is_blank()) ++m_place;
    return m_text.substr(first, m_place - first);
  }

  Text_problem problem(const Element& element, std::size_t i) const
  {
    const std::size_t line = m_format == "ascii" ? line_at(m_text, m_place) : 0;
    const std::string item = element.name + ' ' + std::to_string(i + 1);
    if(m_is_too_long)
      return {"bad index", item + " has a list that is longer than the file", line, true};
    return {"truncated file",
            "the file ends within " + item + " of " + std::to_string(element.count), line};
  }

  std::string_view m_text;
  std::size_t m_place = 0;
  std::string m_format;
  std::vector<Element> m_elements;
  bool m_is_too_long = false;
};

} // namespace

std::vector<Text_problem> problems_of_ply(std::string_view text)
{
  return Ply_text(text).problems();
}

} // namespace vfc
