// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_COMPONENTS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_COMPONENTS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The components of a network: which of them are closed and which have junctions, none of which
// ever changes, and the nodes that they have since these were numbered last.
class Curve_components
{
public:
  Curve_components() : m_first_node(1, 0) {}

  std::size_t count() const { return m_is_closed.size(); }
  std::size_t first_node(std::size_t c) const { return m_first_node[c]; }
  bool is_closed(std::size_t c) const { return m_is_closed[c]; }
  bool has_junction(std::size_t c) const { return m_has_junction[c]; }
  bool has_junction() const
  {
    return std::find(m_has_junction.begin(), m_has_junction.end(), true) != m_has_junction.end();
  }

  // A node of component c has this number of edges.
  void note_degree(std::size_t c, std::size_t degree)
  {
    if(c >= count()) {
      m_is_closed.resize(c + 1, true);
      m_has_junction.resize(c + 1, false);
    }
    if(degree != 2) m_is_closed[c] = false;
    if(degree > 2) m_has_junction[c] = true;
  }

  // Takes the nodes in the order of the components.
  template <typename Nodes>
  void number(const Nodes& nodes)
  {
    m_first_node.assign(count() + 1, 0);
    for(const auto& node : nodes) ++m_first_node[node.component + 1];
    for(std::size_t c = 0; c < count(); ++c) m_first_node[c + 1] += m_first_node[c];
  }

  bool operator==(const Curve_components& other) const
  {
    return m_first_node == other.m_first_node && m_is_closed == other.m_is_closed &&
           m_has_junction == other.m_has_junction;
  }

  // Writes or reads everything, see State_writer.
  template <typename Archive>
  void serialize(Archive& archive)
  {
    archive(m_first_node, m_is_closed, m_has_junction);
  }

private:
  std::vector<std::uint32_t> m_first_node; // per component, and the number of nodes at the end
  std::vector<bool> m_is_closed, m_has_junction;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_COMPONENTS_H
