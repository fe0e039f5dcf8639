// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/Ply_items.h"

#include <CGAL/Volume_filling_curves/internal/curve_files/Binary_ply_items.h>

#include <limits>

namespace vfc {
namespace {

namespace files = CGAL::Volume_filling_curves::internal;

} // namespace

Ply_items::Ply_items(std::string_view text, Mesh_findings& findings)
    : m_size(text.size()),
      m_findings(findings),
      m_words(text),
      m_header(m_words, true, m_draft),
      m_bytes(m_words.rest())
{
  check_header();
}

void Ply_items::check_header()
{
  for(const auto& defect : m_draft.defects.listed())
    m_findings.add_error(to_string(defect.kind), defect.message, {defect.line});
  for(const Element& element : m_header.elements())
    if(element.count > m_size)
      refuse(element, "truncated file", "more is announced than the file can hold");
}

const std::vector<Ply_items::Element>& Ply_items::elements() const
{
  static const std::vector<Element> none;
  return m_findings.has_error() ? none : m_header.elements();
}

void Ply_items::refuse(const Element& element, const std::string& kind, const std::string& message)
{
  m_findings.add_error(kind, message, {element.line});
}

bool Ply_items::next(const Element& element)
{
  m_number = m_element == &element ? m_number + 1 : 1;
  m_element = &element;
  m_values.clear();
  m_starts.assign(1, 0);
  m_line = is_ascii() ? m_words.line() : 0;
  for(const Property& property : element.properties) {
    if(!read(property)) return complain(element);
    m_starts.push_back(m_values.size());
  }
  return true;
}

bool Ply_items::read(const Property& property)
{
  double count = 1, value = 0;
  if(property.is_list && !read(property.size_type, count)) return false;
  m_is_list_too_long = !(count >= 0 && count <= static_cast<double>(m_size));
  if(m_is_list_too_long) return false;
  for(double i = 0; i < count; ++i) {
    if(!read(property.type, value)) return false;
    m_values.push_back(value);
  }
  return true;
}

bool Ply_items::read(const Type* type, double& value)
{
  if(is_ascii()) return read_word(type, value);
  if(m_bytes.size() < type->size) return false;
  value = files::binary_ply_number(m_bytes, *type, m_header.format() == Format::BINARY_BIG_ENDIAN);
  m_bytes.remove_prefix(type->size);
  return true;
}

bool Ply_items::read_word(const Type* type, double& value)
{
  std::string_view word = m_words.next_word();
  for(; word.empty(); word = m_words.next_word()) {
    if(m_words.is_at_end()) return false;
    m_words.next_record();
  }
  m_line = m_words.line();
  if(!files::parse_number(word, value)) value = std::numeric_limits<double>::quiet_NaN();
  const bool is_float = type != nullptr && type->kind == Type::REAL && type->size == sizeof(float);
  if(is_float) value = static_cast<float>(value); // what the file could hold in binary
  return true;
}

bool Ply_items::complain(const Element& element)
{
  const std::string item = std::string(element.name) + ' ' + std::to_string(m_number);
  const Mesh_place here{is_ascii() ? m_words.line() : 0};
  if(m_is_list_too_long)
    m_findings.add_error("bad index", item + " has a list that is longer than the file", here);
  else
    m_findings.add_error("truncated file",
                         "the file ends within " + item + " of " + std::to_string(element.count),
                         here);
  return false;
}

} // namespace vfc
