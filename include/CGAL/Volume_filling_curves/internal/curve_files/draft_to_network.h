// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_DRAFT_TO_NETWORK_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_DRAFT_TO_NETWORK_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/Self_contacts.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Arc_checker.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_checker.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Edge_repair.h>
#include <CGAL/Volume_filling_curves/internal/support/Disjoint_sets.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Polyline_conventions.h>

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Conversion of the contents of a file to a network: repairs, checks and, unless there is an error,
// construction.

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

// Unless there is an error, the edges of the file are afterwards those of the curve.
inline void repair_and_check(Curve_draft& file, Junctions junctions)
{
  if(!file.is_complete) return;
  Edge_repair(file).run();
  check_run();
  Curve_checker(file, junctions).run();
  check_run();
  Arc_checker(file).run();
}

// Returns false, and leaves the network unchanged, if there is an error. The points keep their
// order, hence the origins of nodes are vertices of the file.
template <typename Traits>
bool checked_draft_to_network(const Curve_draft& file,
                              Curve_network_3<Traits>& network,
                              std::vector<Curve_defect>& defects)
{
  defects = file.defects.listed();
  if(file.defects.has_error()) return false;
  const auto construct_point = network.traits().construct_point_3_object();
  std::vector<typename Traits::Point_3> points;
  points.reserve(file.points.size());
  for(const auto& p : file.points) points.push_back(construct_point(p[0], p[1], p[2]));
  network = Curve_network_3<Traits>(points, file.edges, network.traits());
  std::vector<bool> is_pinned(points.size(), false);
  for(const std::size_t v : file.pinned) is_pinned[v] = true;
  for(const std::size_t v : network.nodes())
    if(is_pinned[network.origin(v)]) network.set_pinned(v);
  return true;
}

// Makes a network without testing whether its edges meet.
template <typename Traits>
bool draft_to_network(Curve_draft& file,
                      Curve_network_3<Traits>& network,
                      std::vector<Curve_defect>& defects,
                      Junctions junctions)
{
  repair_and_check(file, junctions);
  return checked_draft_to_network(file, network, defects);
}

// The same, but a self-contact is an error.
template <typename Traits>
bool draft_to_embedded_network(Curve_draft& file,
                               Curve_network_3<Traits>& network,
                               std::vector<Curve_defect>& defects,
                               Junctions junctions)
{
  repair_and_check(file, junctions);
  if(file.is_complete && !file.edges.empty()) Contact_checker(file).run();
  return checked_draft_to_network(file, network, defects);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_DRAFT_TO_NETWORK_H
