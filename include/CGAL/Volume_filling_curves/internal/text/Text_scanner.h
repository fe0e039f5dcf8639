// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_TEXT_TEXT_SCANNER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_TEXT_TEXT_SCANNER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/text/number_text.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Scanner that divides a text into records and words without copying. A record is a line, which a
// backslash at its end continues; a comment extends from a word that starts with # to the end of
// the line. Lines end with LF, CR LF or CR; the last line may also end with the text. A UTF-8 byte
// order mark is skipped. Linear time.
class Text_scanner
{
public:
  explicit Text_scanner(std::string_view text) : m_text(text)
  {
    const std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if(text.substr(0, 3) == byte_order_mark) m_text.remove_prefix(3);
  }

  bool is_at_end() const { return m_position == m_text.size(); }

  // returns the number of the current line, from 1
  std::size_t line() const { return m_line; }

  // Returns the unread text.
  std::string_view rest() const { return m_text.substr(m_position); }

  // returns the next word of the record, which is empty at the end of the record
  std::string_view next_word()
  {
    skip_blanks();
    const std::size_t first = m_position;
    while(!is_at_end() && !is_blank(peek()) && !is_at_line_end() && !is_at_continuation())
      ++m_position;
    const std::string_view word = m_text.substr(first, m_position - first);
    if(word.empty() || word[0] != '#') return word;
    while(!is_at_end() && !is_at_line_end()) ++m_position;
    return {};
  }

  // Skips the rest of the record.
  void next_record()
  {
    while(!next_word().empty()) {
    }
    if(!is_at_end()) skip_line_end();
  }

private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

  char peek() const { return m_text[m_position]; }

  bool is_at_line_end() const { return peek() == '\n' || peek() == '\r'; }

  bool is_at_continuation() const
  {
    if(peek() != '\\' || m_position + 1 == m_text.size()) return false;
    return m_text[m_position + 1] == '\n' || m_text[m_position + 1] == '\r';
  }

  void skip_blanks()
  {
    while(!is_at_end()) {
      if(is_blank(peek())) {
        ++m_position;
      } else if(is_at_continuation()) {
        ++m_position;
        skip_line_end();
      } else {
        return;
      }
    }
  }

  void skip_line_end()
  {
    m_position += m_text.substr(m_position, 2) == "\r\n" ? 2 : 1;
    ++m_line;
  }

  std::string_view m_text;
  std::size_t m_position = 0, m_line = 1;
};

// Part of a text before the first line with a byte that no text file contains, and this byte.
class Readable_text
{
public:
  explicit Readable_text(std::string_view text) : m_text(text)
  {
    for(std::size_t i = 0; i < text.size(); ++i) {
      const auto byte = static_cast<unsigned char>(text[i]);
      if((byte >= 0x20 && byte != 0x7f) || (byte >= '\t' && byte <= '\r')) continue;
      const std::size_t line_end = text.substr(0, i).find_last_of("\n\r");
      m_text = text.substr(0, line_end == std::string_view::npos ? 0 : line_end + 1);
      m_bad_byte = byte;
      return;
    }
  }

  std::string_view text() const { return m_text; }

  bool is_complete() const { return m_bad_byte < 0; }

  std::string complaint() const
  {
    return "byte " + std::to_string(m_bad_byte) + " does not belong in a text file" +
           (m_bad_byte == 0 ? "; is it UTF-16?" : "");
  }

private:
  std::string_view m_text;
  int m_bad_byte = -1;
};

// Returns a word in quotes for a message: shortened, and in printable ASCII.
inline std::string quoted(std::string_view word)
{
  const std::size_t max_length = 40;
  std::string text(word.substr(0, max_length));
  for(char& c : text)
    if(c < 0x20 || c > 0x7e) c = '?';
  return "'" + text + (word.size() > max_length ? "...'" : "'");
}

// Returns whether a number outside the range of double is too small, not too large. The position of
// its first nonzero digit decides.
inline bool is_underflow(std::string_view number)
{
  const std::size_t e = (std::min)(number.find_first_of("eE"), number.size());
  const std::string_view mantissa = number.substr(0, e);
  const auto point = static_cast<long long>((std::min)(mantissa.find('.'), mantissa.size()));
  const auto digit = static_cast<long long>(mantissa.find_first_of("123456789"));
  const std::string_view exponent = number.substr((std::min)(e + 1, number.size()));
  const bool has_sign = !exponent.empty() && (exponent[0] == '+' || exponent[0] == '-');
  long long shift = 0;
  const auto [end, error] = number_from_text(exponent.data() + (has_sign ? 1 : 0),
                                             exponent.data() + exponent.size(), shift);
  const bool is_negative = has_sign && exponent[0] == '-';
  const long long enough = 1LL << 60; // more than the digits of any text
  if(error == std::errc::result_out_of_range || shift > enough) return is_negative;
  return point - digit + (is_negative ? -shift : shift) < 0;
}

// Reads a number, which must be the whole word, independently of the locale. As in IEEE 754,
// numbers that are too large become infinite, and numbers that are too small become zero.
inline bool parse_number(std::string_view word, double& number)
{
  const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  const char* const first = word.data() + (has_plus ? 1 : 0);
  const char* const last = word.data() + word.size();
  const auto [end, error] = number_from_text(first, last, number);
  if(error == std::errc::result_out_of_range) {
    const double magnitude = is_underflow(word) ? 0. : std::numeric_limits<double>::infinity();
    number = std::copysign(magnitude, word[0] == '-' ? -1. : 1.);
    return end == last;
  }
  return error == std::errc() && end == last;
}

// Reads an integer, which must be the whole word.
template <typename Integer>
bool parse_integer(std::string_view word, Integer& number)
{
  return parse_all(word, number);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_TEXT_TEXT_SCANNER_H
