// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_XML_SCANNER_H
#define VFC_XML_SCANNER_H

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace vfc {

// Scanner of an XML text, which visits the tags and returns the text between them, without copying.
// It does not expand entities or check whether tags are balanced. Linear time.
class Xml_scanner
{
public:
  explicit Xml_scanner(std::string_view text) : m_text(text) {}

  // Goes to the next tag, over comments and declarations. Returns whether there is one that ends.
  bool next_tag()
  {
    do {
      const std::size_t start = m_text.find('<', m_position);
      if(start == std::string_view::npos) return end();
      const bool is_comment = m_text.substr(start, 4) == "<!--";
      const std::size_t stop = m_text.find(is_comment ? "-->" : ">", start + 1);
      if(stop == std::string_view::npos) return end();
      m_tag = m_text.substr(start + 1, stop - start - 1);
      go_to(stop + (is_comment ? 3 : 1));
    } while(!m_tag.empty() && (m_tag[0] == '?' || m_tag[0] == '!'));
    return true;
  }

  // of the tag, without the slash of an end tag
  std::string_view name() const
  {
    const std::string_view tag = m_tag.substr(is_end() ? 1 : 0);
    return tag.substr(0, (std::min)(tag.find_first_of(" \t\r\n/"), tag.size()));
  }

  bool is_end() const { return !m_tag.empty() && m_tag.front() == '/'; }
  bool is_empty() const { return !m_tag.empty() && m_tag.back() == '/'; }

  // returns the value of an attribute, which is empty if it is absent
  std::string_view attribute(std::string_view key) const
  {
    for(std::size_t position = m_tag.find('='); position != std::string_view::npos;) {
      const std::string_view before = trimmed(m_tag.substr(0, position));
      const std::size_t open = m_tag.find_first_not_of(blanks, position + 1);
      if(open == std::string_view::npos || (m_tag[open] != '"' && m_tag[open] != '\'')) return {};
      const std::size_t close = m_tag.find(m_tag[open], open + 1);
      if(close == std::string_view::npos) return {};
      const std::size_t blank = before.find_last_of(blanks);
      if(before.substr(blank == std::string_view::npos ? 0 : blank + 1) == key)
        return m_tag.substr(open + 1, close - open - 1);
      position = m_tag.find('=', close);
    }
    return {};
  }

  // the text from here to the next tag
  std::string_view content() const
  {
    return m_text.substr(m_position, m_text.find('<', m_position) - m_position);
  }

  // the number of the line behind the tag, from 1
  std::size_t line() const { return m_line; }

private:
  static constexpr std::string_view blanks = " \t\r\n";

  static std::string_view trimmed(std::string_view text)
  {
    return text.substr(0, text.find_last_not_of(blanks) + 1);
  }

  bool end()
  {
    m_tag = {};
    go_to(m_text.size());
    return false;
  }

  void go_to(std::size_t position)
  {
    const std::string_view passed = m_text.substr(m_position, position - m_position);
    m_line += static_cast<std::size_t>(std::count(passed.begin(), passed.end(), '\n'));
    m_position = position;
  }

  std::string_view m_text, m_tag;
  std::size_t m_position = 0, m_line = 1;
};

} // namespace vfc

#endif // VFC_XML_SCANNER_H
