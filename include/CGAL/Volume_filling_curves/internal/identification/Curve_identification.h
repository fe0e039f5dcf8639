// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_IDENTIFICATION_CURVE_IDENTIFICATION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_IDENTIFICATION_CURVE_IDENTIFICATION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/Self_contacts.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Link_identification.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Link_identity.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/diagram_of_curve.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/simplified_diagram.h>
#include <CGAL/Volume_filling_curves/internal/flow/Curve_simplifier.h>
#include <CGAL/Volume_filling_curves/internal/polygon_search/Polygon_search.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Identification of the link that closed curves form: a copy is simplified by certified operations
// and projected. If the name is not proved but may be, a search for fewer edges and a second
// projection follow.
template <typename Network>
class Curve_identification
{
  using Guard = Isotopy_guard_3<typename Network::Traits>;

public:
  // \pre the network has no garbage
  // \throws std::invalid_argument if the curves are not embedded, not all closed, or branch
  Curve_identification(const Network& curves, Run_watch& watch) : m_curves(curves), m_watch(watch)
  {
    check_embedded(m_curves);
    (void)closed_polygons(m_curves);
  }

  // \throws Run_stopped in a Watched_scope
  Link_identity operator()()
  {
    simplify();
    Link_identification first(diagram());
    Link_identity identity = first();
    if(!first.can_be_proved_by_fewer_crossings() || m_curves.number_of_edges() > max_searched_edges)
      return identity;
    search();
    simplify();
    Link_identity second = Link_identification(diagram())();
    return second.is_proved ? second : identity;
  }

private:
  // Petronio and Zanellati's PZ120 has 148; no other curve of the shared data needs the search.
  static constexpr std::size_t max_searched_edges = 200;

  void simplify()
  {
    Guard guard(m_curves);
    Curve_simplifier<Guard>(guard, std::numeric_limits<double>::infinity()).run(&m_watch);
    m_watch.check();
    guard.collect_garbage();
  }

  Planar_diagram diagram() const
  {
    constexpr std::size_t number_of_directions = 20;
    return simplified_diagram(best_diagram(closed_polygons(m_curves), number_of_directions));
  }

  void search()
  {
    constexpr std::size_t number_of_searches = 1;
    Polygon_search<Guard, Sequential_tag> search(m_curves, Search_parameters(), number_of_searches,
                                                 0);
    const auto go_on = [&] {
      m_watch.check();
      return true;
    };
    search.run(go_on);
    Guard guard(m_curves);
    search.apply(guard, go_on);
    guard.collect_garbage();
  }

  Network m_curves;
  Run_watch& m_watch;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_IDENTIFICATION_CURVE_IDENTIFICATION_H
