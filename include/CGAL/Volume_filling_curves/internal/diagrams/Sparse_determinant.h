// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_SPARSE_DETERMINANT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_SPARSE_DETERMINANT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Prime_field.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Determinant of a sparse square matrix modulo a prime, by elimination. The next pivot is in one of
// the shortest rows, in a column with the fewest entries (Markowitz 1957): matrices of planar
// diagrams hardly fill in. A diagram of 7,600 crossings takes some hundredths of a second.
class Sparse_determinant
{
public:
  using Number = Prime_field::Number;

  Sparse_determinant(std::size_t n, const Prime_field& field)
      : m_field(field), m_rows(n), m_columns(n)
  {}

  void add(std::size_t row, std::size_t column, Number x)
  {
    for(Entry& entry : m_rows[row])
      if(entry.column == column) {
        entry.value = m_field.sum(entry.value, x);
        return;
      }
    m_rows[row].push_back({static_cast<std::uint32_t>(column), x});
  }

  // Returns the determinant. Consumes the matrix.
  // \throws Run_stopped in a Watched_scope
  Number operator()()
  {
    begin();
    Number result = 1;
    unsigned steps = 0;
    while(!m_queue.empty()) {
      check_run_sometimes(steps);
      const auto [length, row] = m_queue.top();
      m_queue.pop();
      if(m_is_done[row] || length != m_rows[row].size()) continue;
      if(length == 0) return 0;
      result = m_field.product(result, eliminate(row));
    }
    return is_odd() ? m_field.negative(result) : result;
  }

private:
  struct Entry
  {
    std::uint32_t column;
    Number value;
  };
  using Row = std::vector<Entry>; // by column

  void begin()
  {
    m_is_done.assign(m_rows.size(), false);
    m_pivots.resize(m_rows.size());
    for(std::size_t r = 0; r < m_rows.size(); ++r) {
      Row& row = m_rows[r];
      std::sort(row.begin(), row.end(),
                [](const Entry& a, const Entry& b) { return a.column < b.column; });
      row.erase(std::remove_if(row.begin(), row.end(), [](const Entry& e) { return e.value == 0; }),
                row.end());
      for(const Entry& entry : row) m_columns[entry.column].push_back(r);
      m_queue.push({row.size(), r});
    }
  }

  // Clears the column of the pivot in all other rows; returns the pivot.
  Number eliminate(std::size_t r)
  {
    m_is_done[r] = true;
    const Row pivot_row = std::move(m_rows[r]);
    const Entry pivot = *std::min_element(
        pivot_row.begin(), pivot_row.end(), [this](const Entry& a, const Entry& b) {
          return m_columns[a.column].size() < m_columns[b.column].size();
        });
    m_pivots[r] = pivot.column;
    const Number scale = m_field.inverse(pivot.value);
    for(const std::size_t other : m_columns[pivot.column]) {
      if(m_is_done[other]) continue;
      const Row& row = m_rows[other];
      const auto found = std::lower_bound(
          row.begin(), row.end(), pivot.column,
          [](const Entry& entry, std::uint32_t column) { return entry.column < column; });
      if(found == row.end() || found->column != pivot.column) continue; // cancelled before
      subtract(pivot_row, m_field.product(found->value, scale), pivot.column, other);
      m_queue.push({m_rows[other].size(), other});
    }
    m_columns[pivot.column].clear();
    return pivot.value;
  }

  // Subtracts a multiple of a row from another one, apart from the pivot's column.
  void subtract(const Row& row, Number factor, std::uint32_t column, std::size_t from)
  {
    Row& target = m_rows[from];
    m_sum.clear();
    auto a = target.begin();
    for(const Entry& b : row) {
      for(; a != target.end() && a->column < b.column; ++a) m_sum.push_back(*a);
      const bool is_there = a != target.end() && a->column == b.column;
      const Number change = m_field.negative(m_field.product(factor, b.value));
      const Number value = is_there ? m_field.sum(a->value, change) : change;
      if(!is_there) m_columns[b.column].push_back(from);
      if(is_there) ++a;
      if(value != 0 && b.column != column) m_sum.push_back({b.column, value});
    }
    m_sum.insert(m_sum.end(), a, target.end());
    target.assign(m_sum.begin(), m_sum.end());
  }

  // whether the permutation from rows to columns is odd
  bool is_odd()
  {
    bool result = false;
    for(std::size_t r = 0; r < m_pivots.size(); ++r)
      for(; m_pivots[r] != r; result = !result) std::swap(m_pivots[r], m_pivots[m_pivots[r]]);
    return result;
  }

  using Item = std::pair<std::size_t, std::size_t>; // length, maybe a former one, and row

  const Prime_field m_field;
  std::vector<Row> m_rows;
  std::vector<std::vector<std::size_t>> m_columns; // rows that have, or had, an entry there
  std::vector<bool> m_is_done;
  std::vector<std::size_t> m_pivots; // the column of each row
  std::priority_queue<Item, std::vector<Item>, std::greater<Item>> m_queue;
  Row m_sum;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_SPARSE_DETERMINANT_H
