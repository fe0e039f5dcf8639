// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_TEXT_FORM_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_TEXT_FORM_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/Certificate_reader.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Certificate_writer.h>
#include <CGAL/Volume_filling_curves/internal/text/number_text.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Conversion of certificates to text, one operation per line, and back, without loss: a round trip
// restores the same bytes. Linear time.

constexpr std::string_view text_form_magic = "VFC-CERT text";

inline bool is_text_form(std::string_view content)
{
  return content.substr(0, text_form_magic.size()) == text_form_magic;
}

// Binary form to text.
class Text_form_writer
{
  using Kind = Certificate_operation::Kind;

public:
  // \throws std::invalid_argument
  std::string operator()(std::string_view bytes)
  {
    Certificate_reader reader(bytes);
    try {
      m_text = std::string(text_form_magic) + ' ' + std::to_string(certificate_version) + '\n';
      const Certificate_header header = reader.header();
      add("start", header.nodes, header.edges, header.components, to_hex(header.curve));
      for(;;) {
        const Certificate_operation operation = reader.operation();
        if(operation.kind == Kind::END) break;
        add(operation);
      }
      const Certificate_trailer trailer = reader.trailer();
      add("end", trailer.operations, trailer.nodes, trailer.edges, to_hex(trailer.curve));
      add("record", to_hex(trailer.record));
    } catch(const Certificate_format_error& error) {
      throw std::invalid_argument(error.what());
    }
    return m_text;
  }

private:
  void add(const Certificate_operation& operation)
  {
    const Position& p = operation.position;
    switch(operation.kind) {
    case Kind::MOVE:
      return add("move", operation.node, p[0], p[1], p[2]);
    case Kind::INSERT:
      return add("insert", operation.node, operation.other, p[0], p[1], p[2]);
    case Kind::REMOVE:
      return add("remove", operation.node);
    case Kind::END:
      return;
    }
  }

  template <typename... Words>
  void add(const char* keyword, const Words&... words)
  {
    m_text += keyword;
    (add_word(words), ...);
    m_text += '\n';
  }

  void add_word(const std::string& word) { m_text += ' ' + word; }
  void add_word(std::uint64_t number) { m_text += ' ' + std::to_string(number); }

  void add_word(double number)
  {
    m_text += ' ';
    append_number(m_text, number);
  }

  std::string m_text;
};

// Text to binary form. Errors name the line.
class Text_form_reader
{
  using Kind = Certificate_operation::Kind;

public:
  explicit Text_form_reader(std::string_view text) : m_text(text) {}

  // \throws std::invalid_argument
  std::string operator()()
  {
    read_line();
    if(m_words.size() != 3 || m_words[2] != std::to_string(certificate_version))
      fail("this version of the format is not supported, only version " +
           std::to_string(certificate_version));
    read_line();
    require(m_words.size() == 5 && m_words[0] == "start", "the line of the start is wrong");
    m_writer.write(Certificate_header{number(1), number(2), number(3), digest(4)});
    for(read_line(); m_words[0] != "end"; read_line()) m_writer.write(operation());
    require(m_words.size() == 5, "the line of the end is wrong");
    require(number(1) == m_writer.number_of_operations(), "there are not as many operations");
    m_writer.write_end(number(2), number(3), digest(4));
    read_line();
    require(m_words.size() == 2 && m_words[0] == "record", "the line of the record is wrong");
    m_writer.write_record_hash(digest(1));
    require(m_text.empty(), "there is something behind the end of the record");
    return m_writer.bytes();
  }

private:
  [[noreturn]] void fail(const std::string& message) const
  {
    throw std::invalid_argument("line " + std::to_string(m_line) + ": " + message);
  }

  void require(bool condition, const char* message) const
  {
    if(!condition) fail(message);
  }

  // Lines have at least one word.
  void read_line()
  {
    ++m_line;
    const std::size_t end = m_text.find('\n');
    require(end != std::string_view::npos, "the record ends too early");
    m_words.clear();
    for(std::size_t begin = 0; begin <= end;) {
      const std::size_t stop = m_text.find_first_of(" \n", begin);
      require(stop > begin, "there is a superfluous space");
      m_words.push_back(m_text.substr(begin, stop - begin));
      begin = stop + 1;
    }
    m_text.remove_prefix(end + 1);
  }

  Certificate_operation operation() const
  {
    Certificate_operation operation;
    const auto is = [&](const char* keyword, std::size_t size) {
      return m_words[0] == keyword && m_words.size() == size;
    };
    if(is("move", 5))
      operation = {Kind::MOVE, number(1), 0, position(2)};
    else if(is("insert", 6))
      operation = {Kind::INSERT, number(1), number(2), position(3)};
    else if(is("remove", 2))
      operation = {Kind::REMOVE, number(1), 0, {}};
    else
      require(false, "there is no such operation");
    return operation;
  }

  template <typename Number>
  Number parsed(std::size_t k) const
  {
    Number x = 0;
    require(parse_all(m_words[k], x), "a number is wrong");
    return x;
  }

  // Returns the number of a node, which is less than 2^61, as in the binary form.
  std::uint64_t number(std::size_t k) const
  {
    const auto x = parsed<std::uint64_t>(k);
    require(x >> 61 == 0, "a number is too large");
    return x;
  }

  Position position(std::size_t k) const
  {
    Position p{};
    for(double& x : p) {
      x = parsed<double>(k++);
      require(std::isfinite(x), "a coordinate is not finite");
    }
    return p;
  }

  Sha256::Digest digest(std::size_t k) const
  {
    Sha256::Digest digest{};
    require(m_words[k].size() == 2 * digest.size(), "a hash does not have 64 digits");
    for(std::size_t i = 0; i < m_words[k].size(); ++i) {
      const std::size_t value = std::string_view("0123456789abcdef").find(m_words[k][i]);
      require(value != std::string_view::npos, "a hash has a digit that is none");
      digest[i / 2] = static_cast<std::uint8_t>(16u * digest[i / 2] + value);
    }
    return digest;
  }

  std::string_view m_text;
  std::vector<std::string_view> m_words;
  std::size_t m_line = 0;
  Certificate_writer m_writer;
};

inline std::string to_text_form(std::string_view bytes)
{
  return Text_form_writer()(bytes);
}

inline std::string from_text_form(std::string_view text)
{
  return Text_form_reader(text)();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_TEXT_FORM_H
