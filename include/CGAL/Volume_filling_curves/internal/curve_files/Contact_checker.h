// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_CONTACT_CHECKER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_CONTACT_CHECKER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/Self_contacts.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/support/Disjoint_sets.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Exact check for edges of a repaired file that meet outside a common node.
// O(n log^2 n) unless many edges have intersecting bounding boxes.
class Contact_checker
{
  using Traits = Curve_flow_traits_3<>;

public:
  explicit Contact_checker(Curve_draft& file)
      : m_file(file), m_components(component_numbers(file.points.size(), file.edges))
  {}

  void run()
  {
    std::vector<Traits::Point_3> points;
    points.reserve(m_file.points.size());
    for(const auto& p : m_file.points) points.emplace_back(p[0], p[1], p[2]);
    Self_contacts<Traits> contacts(points, m_file.edges);
    contacts.find(Defect_list::max_listed);
    std::set<std::vector<std::size_t>> reported; // equal nodes: as many as four pairs
    for(const auto& [e, f] : contacts.kept()) {
      const auto [message, nodes] = contacts.describe(e, f);
      if(reported.insert(nodes).second)
        m_file.add_defect(Curve_defect_kind::SELF_CONTACT, message, m_file.point_lines[nodes[0]],
                          nodes, m_components[nodes[0]]);
    }
    if(contacts.count() > contacts.kept().size())
      m_file.defects.add_note({Curve_defect_kind::SELF_CONTACT,
                               (contacts.has_all() ? "" : "at least ") +
                                   std::to_string(contacts.count()) +
                                   " pairs of edges meet in total, the first " +
                                   std::to_string(contacts.kept().size()) + " are listed"});
  }

private:
  Curve_draft& m_file;
  std::vector<std::size_t> m_components;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_CONTACT_CHECKER_H
