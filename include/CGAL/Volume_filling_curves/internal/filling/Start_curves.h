// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_START_CURVES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_START_CURVES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Self_contacts.h>
#include <CGAL/Volume_filling_curves/internal/domain/Least_depth.h>
#include <CGAL/Volume_filling_curves/internal/domain/containment.h>
#include <CGAL/Volume_filling_curves/internal/filling/Finger_stations.h>
#include <CGAL/Volume_filling_curves/internal/filling/Port_arcs.h>
#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Node_constraint.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <iomanip>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Curves from which a filling starts: those of the caller, or arcs between the ports, or a circle
// in each part of the domain that is wide enough. All are checked.
template <typename Network, typename Survey, typename ConcurrencyTag>
class Start_curves
{
  using Traits = typename Network::Traits;
  using Point_3 = typename Network::Point_3;
  using Domain = std::decay_t<decltype(std::declval<const Survey&>().samples().domain())>;

public:
  // Takes the unit of all lengths, for messages.
  Start_curves(Network& curves, const Survey& survey, double unit)
      : m_curves(curves),
        m_survey(survey),
        m_domain(survey.samples().domain()),
        m_parameters(survey.parameters()),
        m_watch(survey.watch()),
        m_unit(unit)
  {}

  // Replaces the curves, unless the caller gave some.
  void place()
  {
    if(!m_parameters.ports.empty())
      place_arcs();
    else if(m_curves.number_of_nodes() == 0)
      place_circles();
  }

  // Checks the curves, and returns whether there was time for it.
  bool check_in_time()
  {
    try {
      const Watched_scope scope(&m_watch);
      check();
      return true;
    } catch(const Run_stopped&) {
      return !m_circles.empty(); // a circle in a ball is embedded, and inside
    }
  }

  bool are_circles() const { return !m_circles.empty(); }

  // the circles or arcs that were placed
  const std::vector<std::vector<Point_3>>& placed() const
  {
    return m_arcs.empty() ? m_circles : m_arcs;
  }

  // the necks of the arcs
  const std::vector<Port_neck<Point_3>>& necks() const { return m_necks; }

private:
  void place_circles()
  {
    m_circles = m_survey.circles();
    if(m_circles.empty() && m_watch.must_stop()) throw Run_stopped();
    if(!(m_survey.widest_radius() > 0))
      throw std::invalid_argument("the domain contradicts itself: points are inside, and all at "
                                  "distance 0 from the boundary");
    if(m_circles.empty())
      refuse_wall_distance("no point was found that is farther from the boundary than ",
                           m_survey.widest_radius());
    m_curves = Network(m_circles, CGAL::parameters::default_values(), m_curves.traits());
  }

  // The nodes of necks are so near to one another that no edge between them is divided, also where
  // the domain is thin.
  void place_arcs()
  {
    constexpr double share_of_spacing = 0.5;
    const Watched_scope scope(&m_watch);
    if(m_curves.number_of_nodes() > 0)
      throw std::invalid_argument("ports: there are curves, too, and their ends are the ports");
    const Port_arcs<Domain, Traits> arcs(
        m_domain, m_survey.thickness(), m_parameters.ports, m_parameters.wall_distance,
        share_of_spacing * m_parameters.spacing, m_curves.traits());
    check_wall_distance(arcs.paths());
    m_curves = arcs.network();
    m_necks = arcs.necks();
    m_arcs = arcs.polylines();
  }

  [[noreturn]] void refuse_wall_distance(const std::string& complaint, double farthest) const
  {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::setprecision(9) << complaint << m_unit * farthest;
    refuse_value(internal_np::wall_distance_t(), m_unit * m_parameters.wall_distance, text.str());
  }

  // A circle is not checked against the wall distance: it lies in a ball that keeps it. Necks do
  // not keep it, and the paths between them have been checked.
  void check() const
  {
    check_number_of_shares(m_parameters.volume_shares, m_curves.number_of_components());
    if(m_parameters.start == Filling_start::TREE)
      check_sliding(m_curves, "; Filling_start::CIRCLE grows without fingers");
    if(m_circles.empty())
      check_embedded(m_curves);
    else if(!first_contact(m_curves).empty())
      throw std::invalid_argument(
          "the coordinates of the domain are too large for the thickness: rounded to double, a "
          "circle of that size meets itself; move the domain nearer to the origin");
    try {
      check_inside(m_curves, m_domain);
    } catch(const std::invalid_argument& error) {
      if(m_circles.empty()) throw;
      throw std::invalid_argument("the domain contradicts itself: in the widest ball inside, " +
                                  std::string(error.what()));
    }
    if(m_circles.empty() && m_arcs.empty()) check_wall_distance(m_curves);
  }

  void check_wall_distance(const Network& curves) const
  {
    if(m_parameters.wall_distance == 0) return;
    for(const std::size_t v : curves.nodes()) {
      const Node_constraint& constraint = curves.constraint(v);
      if(constraint.kind() == Node_constraint::Kind::BOUNDARY &&
         constraint.distance() < m_parameters.wall_distance)
        refuse_wall_distance("a node is constrained to the distance from the boundary ",
                             constraint.distance());
    }
    const Least_depth<ConcurrencyTag, Network, Domain> depths(curves, m_domain);
    const double distance = depths().distance;
    if(!(distance > m_parameters.wall_distance))
      refuse_wall_distance("the curve to start from comes as near to the boundary as ", distance);
  }

  Network& m_curves;
  const Survey& m_survey;
  const Domain& m_domain;
  const Filling_parameters<Point_3>& m_parameters;
  Run_watch& m_watch;
  const double m_unit;
  std::vector<std::vector<Point_3>> m_circles, m_arcs;
  std::vector<Port_neck<Point_3>> m_necks;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_START_CURVES_H
