// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NODE_LIST_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NODE_LIST_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Some nodes and where they are, one array for each coordinate.
class Node_list
{
public:
  using Index = std::uint32_t;

  std::size_t size() const { return m_indices.size(); }
  Index index(std::size_t k) const { return m_indices[k]; }
  const double* x() const { return m_x.data(); }
  const double* y() const { return m_y.data(); }
  const double* z() const { return m_z.data(); }

  void clear()
  {
    m_indices.clear();
    for(auto* values : {&m_x, &m_y, &m_z}) values->clear();
  }

  void push_back(Index index, const Vector& position)
  {
    m_indices.push_back(index);
    m_x.push_back(position.x());
    m_y.push_back(position.y());
    m_z.push_back(position.z());
  }

  // Adds the places first, ..., beyond - 1 of another list.
  void append(const Node_list& other, std::size_t first, std::size_t beyond)
  {
    append(other.m_indices, m_indices, first, beyond);
    append(other.m_x, m_x, first, beyond);
    append(other.m_y, m_y, first, beyond);
    append(other.m_z, m_z, first, beyond);
  }

  // Removes all that are farther from a place.
  void keep_within(const Vector& p, double distance)
  {
    const double squared_distance = distance * distance;
    std::size_t count = 0;
    for(std::size_t k = 0; k < size(); ++k) {
      m_indices[count] = m_indices[k];
      const double x = m_x[count] = m_x[k], y = m_y[count] = m_y[k], z = m_z[count] = m_z[k];
      count += (Vector(x, y, z) - p).squaredNorm() <= squared_distance ? 1 : 0;
    }
    m_indices.resize(count);
    for(auto* values : {&m_x, &m_y, &m_z}) values->resize(count);
  }

private:
  template <typename T>
  static void append(const std::vector<T>& from,
                     std::vector<T>& to,
                     std::size_t first,
                     std::size_t beyond)
  {
    to.insert(to.end(), from.data() + first, from.data() + beyond);
  }

  std::vector<Index> m_indices;
  std::vector<double> m_x, m_y, m_z;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NODE_LIST_H
