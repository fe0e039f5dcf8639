// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/vtp_in_ascii.h"

#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>
#include <CGAL/Volume_filling_curves/internal/text/Xml_scanner.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace vfc {
namespace {

using CGAL::Volume_filling_curves::internal::parse_integer;
using CGAL::Volume_filling_curves::internal::Xml_scanner;

// What stands behind all arrays, for them to point to.
struct Appended_data
{
  std::string_view bytes; // from the underscore on
  bool is_base64 = false;
};

// What arrays belong to, as far as it matters.
bool is_section(std::string_view name)
{
  return name == "Points" || name == "Lines" || name == "Polys" || name == "Strips" ||
         name == "PointData";
}

bool is_encoded(const Xml_scanner& tags)
{
  const std::string_view format = tags.attribute("format");
  return tags.name() == "DataArray" && !tags.is_end() &&
         (format == "binary" || format == "appended");
}

// The most bytes that an array of a file is believed to have. Coordinates shrink to a third,
// indices in order to a twentieth; zeros to a thousandth, but there are few more than points.
std::size_t most_inflated(std::size_t size_of_file)
{
  constexpr std::size_t most_times = 100, free = 1 << 20;
  return free + most_times * size_of_file;
}

std::string without_blanks(std::string_view text)
{
  std::string result;
  for(const char c : text)
    if(!std::isspace(static_cast<unsigned char>(c))) result += c;
  return result;
}

class Ascii_copy
{
public:
  explicit Ascii_copy(std::string_view text) : m_text(text), m_tags(text) { find_appended_data(); }

  bool has_encoded_arrays() const { return m_has_encoded_arrays; }

  std::string run()
  {
    for(m_tags = Xml_scanner(m_text); m_tags.next_tag() && m_tags.name() != "AppendedData";)
      copy_tag();
    if(m_tags.name() == "AppendedData") m_copy += "</VTKFile>";
    return std::move(m_copy);
  }

private:
  // Raw data may look like tags, so that these are read only as far as to where data begin.
  void find_appended_data()
  {
    while(m_tags.next_tag()) {
      m_has_encoded_arrays = m_has_encoded_arrays || is_encoded(m_tags);
      if(m_tags.name() != "AppendedData") continue;
      m_appended.is_base64 = m_tags.attribute("encoding") != "raw";
      const auto behind = static_cast<std::size_t>(m_tags.content().data() - m_text.data());
      const std::size_t start = m_text.find_first_not_of(" \t\r\n", behind);
      if(start == std::string_view::npos || m_text[start] != '_')
        throw Encoding_error("the appended data do not begin with '_'", m_tags.line());
      m_appended.bytes = m_text.substr(start + 1);
      return;
    }
  }

  void copy_tag()
  {
    for(; m_line < m_tags.line(); ++m_line) m_copy += '\n';
    const std::string name(m_tags.name());
    if(name == "DataArray" && !m_tags.is_end()) return copy_array();
    const bool is_end = m_tags.is_end();
    if(is_section(name)) m_section = is_end || m_tags.is_empty() ? "" : name;
    m_copy += is_end ? "</" : "<";
    m_copy += name;
    if(name == "VTKFile" && !is_end) copy_file_attributes();
    m_copy += m_tags.is_empty() ? "/>" : ">";
  }

  void copy_file_attributes()
  {
    m_copy += " type=\"" + std::string(m_tags.attribute("type")) + '"';
    decode([&] {
      m_encoding.emplace(m_tags.attribute("header_type"), m_tags.attribute("byte_order"),
                         m_tags.attribute("compressor"), most_inflated(m_text.size()));
    });
  }

  void copy_array()
  {
    m_copy += "<DataArray Name=\"" + std::string(m_tags.attribute("Name")) + "\">";
    if(is_wanted()) decode([&] { copy_numbers(); });
    if(m_tags.is_empty()) m_copy += "</DataArray>";
  }

  bool is_wanted() const
  {
    if(m_section == "PointData") return m_tags.attribute("Name") == "pinned";
    return !m_section.empty();
  }

  void copy_numbers()
  {
    const std::string_view format = m_tags.attribute("format");
    if(!is_encoded(m_tags)) {
      const std::string_view content = m_tags.is_empty() ? "" : m_tags.content();
      m_line += static_cast<std::size_t>(std::count(content.begin(), content.end(), '\n'));
      m_copy += content;
      return;
    }
    if(!m_encoding) throw Encoding_error("the array is not within <VTKFile>");
    const std::string bytes =
        format == "binary" ? m_encoding->bytes(without_blanks(m_tags.content()), true) : appended();
    m_encoding->append_numbers(m_copy, bytes, m_tags.attribute("type"));
  }

  std::string appended() const
  {
    std::size_t offset = 0;
    if(!parse_integer(m_tags.attribute("offset"), offset) || offset >= m_appended.bytes.size())
      throw Encoding_error("an array is not where its offset points to");
    std::string_view data = m_appended.bytes.substr(offset);
    if(m_appended.is_base64) data = data.substr(0, data.find_first_of(" \t\r\n<"));
    return m_encoding->bytes(data, m_appended.is_base64);
  }

  // Tells the line of what is wrong.
  template <typename Work>
  void decode(const Work& work) const
  {
    try {
      work();
    } catch(const Encoding_error& error) {
      throw Encoding_error(error.what(), m_tags.line());
    }
  }

  std::string_view m_text;
  Xml_scanner m_tags;
  Appended_data m_appended;
  bool m_has_encoded_arrays = false;
  std::optional<Vtk_encoding> m_encoding;
  std::string m_section; // the element that arrays belong to
  std::string m_copy;
  std::size_t m_line = 1; // of the copy's end
};

} // namespace

std::string vtp_in_ascii(std::string text)
{
  Ascii_copy copy(text);
  return copy.has_encoded_arrays() ? copy.run() : text;
}

} // namespace vfc
