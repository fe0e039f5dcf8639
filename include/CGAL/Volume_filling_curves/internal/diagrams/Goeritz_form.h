// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_GOERITZ_FORM_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_GOERITZ_FORM_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Chinese_remainders.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Diagram_faces.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Sparse_determinant.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Symmetric_form.h>

#include <CGAL/Exact_integer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Quadratic form of the surface that the faces of one color form (Goeritz 1933): a sparse symmetric
// matrix, with a row for each face of the other color except one in each part. Its determinant is
// that of the link, and so is its signature after a correction by the crossings at which the
// surface does not follow the orientation (Gordon and Litherland 1978).
class Goeritz_form
{
public:
  // \pre is_planar_diagram(diagram)
  explicit Goeritz_form(const Planar_diagram& diagram)
      : m_is_split(Diagram_faces(diagram).number_of_parts() + diagram.number_of_free_loops > 1)
  {
    const Diagram_faces faces(diagram);
    const bool is_black = number_rows(faces);
    const Diagram_strands strands(diagram);
    for(std::size_t c = 0; c < diagram.crossings.size(); ++c) {
      // corners 1 and 3 are counterclockwise of the upper strand, whatever its orientation
      const bool is_after_over = faces.is_black(faces.face(c, 1)) == is_black;
      const int type = is_after_over ? 1 : -1;
      if(is_after_over != (strands.sign(c) > 0)) m_correction += type;
      const std::size_t corner = is_after_over ? 1 : 0;
      add(m_rows[faces.face(c, corner)], m_rows[faces.face(c, corner + 2)], type);
    }
  }

  // |Alexander(-1)|, exactly, for thousands of crossings
  // \throws Run_stopped in a Watched_scope
  Exact_integer determinant() const
  {
    if(m_is_split) return Exact_integer(0);
    Chinese_remainders remainders(1, max_bits());
    while(!remainders.is_complete()) {
      const Prime_field field = remainders.field();
      Sparse_determinant matrix(m_size, field);
      for(const Entry& entry : m_entries)
        matrix.add(entry.row, entry.column, field.residue(entry.value));
      remainders.add({matrix()});
    }
    const Exact_integer result = remainders.values().front();
    return result < 0 ? Exact_integer(-result) : result;
  }

  // -2 for the right-handed trefoil
  // \throws Run_stopped in a Watched_scope
  int signature() const
  {
    Symmetric_form form(m_size);
    for(const Entry& entry : m_entries) form.add(entry.row, entry.column, entry.value);
    return m_correction - form.signature();
  }

private:
  static constexpr std::size_t none = ~std::size_t(0);

  struct Entry
  {
    std::size_t row, column;
    int value;
  };

  // Makes rows for the faces of the less frequent color; returns whether it is black.
  bool number_rows(const Diagram_faces& faces)
  {
    const std::size_t n = faces.number_of_faces();
    std::size_t black = 0;
    for(std::size_t f = 0; f < n; ++f) black += faces.is_black(f);
    const bool is_black = 2 * black < n;
    std::vector<bool> is_left_out(faces.number_of_parts(), false); // a face of the part
    m_rows.assign(n, none);
    for(std::size_t f = 0; f < n; ++f) {
      if(faces.is_black(f) != is_black) continue;
      if(is_left_out[faces.part(f)]) m_rows[f] = m_size++;
      is_left_out[faces.part(f)] = true;
    }
    return is_black;
  }

  void add(std::size_t a, std::size_t b, int type)
  {
    if(a == b) return; // no row, or the same face twice
    if(a != none) m_entries.push_back({a, a, type});
    if(b != none) m_entries.push_back({b, b, type});
    if(a == none || b == none) return;
    m_entries.push_back({a, b, -type});
    m_entries.push_back({b, a, -type});
  }

  // of the determinant: with all types 1 it would be larger, and then at most the product of the
  // diagonal (Hadamard)
  double max_bits() const
  {
    std::vector<std::size_t> degrees(m_size, 0);
    for(const Entry& entry : m_entries) degrees[entry.row] += entry.row == entry.column;
    double bits = 1;
    for(const std::size_t degree : degrees) bits += std::log2(double((std::max)(degree, one)));
    return bits;
  }

  static constexpr std::size_t one = 1;

  bool m_is_split;
  std::size_t m_size = 0;
  int m_correction = 0;
  std::vector<std::size_t> m_rows; // of each face
  std::vector<Entry> m_entries;    // to be added up
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_GOERITZ_FORM_H
