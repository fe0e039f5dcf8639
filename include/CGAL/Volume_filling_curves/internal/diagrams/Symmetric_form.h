// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_SYMMETRIC_FORM_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_SYMMETRIC_FORM_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Signature of a sparse symmetric matrix, by exact elimination. The next row is one of the shortest
// with a diagonal entry: matrices of planar diagrams hardly fill in. If all diagonal entries are 0,
// a row is first added to another one.
class Symmetric_form
{
public:
  explicit Symmetric_form(std::size_t n) : m_rows(n) {}

  void add(std::size_t i, std::size_t j, const Exact_rational& x)
  {
    const auto entry = m_rows[i].emplace(j, Exact_rational(0)).first;
    entry->second += x;
    if(CGAL::is_zero(entry->second)) m_rows[i].erase(entry);
  }

  // Consumes the matrix.
  // \throws Run_stopped in a Watched_scope
  int signature()
  {
    for(std::size_t i = 0; i < m_rows.size(); ++i) enqueue(i);
    int result = 0;
    while(!m_queue.empty() || find_any_pivot()) {
      check_run();
      const std::size_t i = m_queue.begin()->second;
      result += CGAL::sign(m_rows[i].at(i)) == POSITIVE ? 1 : -1;
      eliminate(i);
    }
    return result;
  }

private:
  using Row = std::map<std::size_t, Exact_rational>;

  void enqueue(std::size_t i)
  {
    if(m_rows[i].count(i) > 0) m_queue.insert({m_rows[i].size(), i});
  }
  void dequeue(std::size_t i) { m_queue.erase({m_rows[i].size(), i}); }

  // Adds row and column j to row and column i, for a nonzero entry (i, j) with zeros on the
  // diagonal. Returns false if the matrix is 0.
  bool find_any_pivot()
  {
    std::size_t i = 0;
    while(i < m_rows.size() && m_rows[i].empty()) ++i;
    if(i == m_rows.size()) return false;
    const std::size_t j = m_rows[i].begin()->first;
    const Row row = m_rows[j];
    for(const auto& [k, x] : row) {
      add(i, k, x); // twice the entry on the diagonal
      add(k, i, x);
    }
    enqueue(i);
    return true;
  }

  void eliminate(std::size_t i)
  {
    dequeue(i);
    const Row row = std::move(m_rows[i]);
    m_rows[i].clear();
    const Exact_rational& pivot = row.at(i);
    for(const auto& entry : row) {
      const std::size_t j = entry.first;
      if(j == i) continue;
      dequeue(j);
      m_rows[j].erase(i);
      for(const auto& [k, x] : row)
        if(k != i) add(j, k, Exact_rational(-entry.second * x / pivot));
      enqueue(j);
    }
  }

  std::vector<Row> m_rows;
  std::set<std::pair<std::size_t, std::size_t>> m_queue; // lengths and rows with a diagonal entry
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_SYMMETRIC_FORM_H
