// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PLY_ITEMS_H
#define VFC_PLY_ITEMS_H

#include "meshes/Mesh_findings.h"

#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Ply_header.h>
#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace vfc {

// The items of a PLY file, ASCII or binary, one after the other. CGAL's reader crashes on headers
// in which a property comes before any element or has another type than expected, refuses files
// without a reason, and allocates whatever a file announces. Linear time.
class Ply_items
{
public:
  using Element = CGAL::Volume_filling_curves::internal::Ply_element;
  using Property = CGAL::Volume_filling_curves::internal::Ply_property;

  // Reads the header.
  Ply_items(std::string_view text, Mesh_findings& findings);

  // the elements that the header announces; none if there is an error in it
  const std::vector<Element>& elements() const;

  // Reads the next item, which is one of an element. Returns whether it is there; otherwise the
  // error is among the findings.
  bool next(const Element& element);

  // the line of the item, or 0 in a binary file
  std::size_t line() const { return m_line; }

  // the values of a property of the item: one, or those of a list; a word that is no number is NaN
  const double* begin(std::size_t property) const { return m_values.data() + m_starts[property]; }
  const double* end(std::size_t property) const { return m_values.data() + m_starts[property + 1]; }

  // Adds an error about an element.
  void refuse(const Element& element, const std::string& kind, const std::string& message);

private:
  using Type = CGAL::Volume_filling_curves::internal::Ply_type;
  using Format = CGAL::Volume_filling_curves::internal::Ply_format;

  bool is_ascii() const { return m_header.format() == Format::ASCII; }
  void check_header();
  bool read(const Property& property);
  bool read(const Type* type, double& value);
  bool read_word(const Type* type, double& value);
  bool complain(const Element& element);

  std::size_t m_size;
  Mesh_findings& m_findings;
  CGAL::Volume_filling_curves::internal::Text_scanner m_words;
  CGAL::Volume_filling_curves::internal::Curve_draft m_draft; // for the header's errors
  CGAL::Volume_filling_curves::internal::Ply_header m_header;
  std::string_view m_bytes; // of a binary file, those not read yet
  const Element* m_element = nullptr;
  std::size_t m_number = 0, m_line = 0;
  std::vector<double> m_values;
  std::vector<std::size_t> m_starts; // of the values of each property, and their end
  bool m_is_list_too_long = false;
};

} // namespace vfc

#endif // VFC_PLY_ITEMS_H
