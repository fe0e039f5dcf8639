// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_SIZE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_SIZE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/filling/Filling_stage.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_estimates.h>
#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <locale>
#include <sstream>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Size of a filling, estimated before it starts. In a wide domain a curve of thickness r has the
// length that length_of_filling() estimates; between walls closer than 2 r its strands lie side by
// side, 2 r apart, and cover half of the walls' area A, with the length A / (4 r). The larger value
// counts. The samples nearest to the boundary give the area.
class Filling_size
{
public:
  // The largest size that is tried; it takes some 30 GB.
  static constexpr double max_nodes = 2e7;

  // With the default thickness: half a minute, and more in domains so thin that no thicker curve
  // fits.
  static constexpr double max_nodes_by_default = 2e5, max_nodes_of_thin_by_default = 2e6;

  // Takes the volume, or the area of a planar domain, the distances of uniform samples to the
  // boundary, the length of edges in units of the thickness, and whether the filling is round.
  Filling_size(double volume,
               std::vector<double> distances,
               double spacing,
               int dimension = 3,
               bool is_round = false)
      : m_is_planar(dimension == 2),
        m_is_round(is_round),
        m_volume(volume),
        m_edge(mean_edge * spacing),
        m_last_edge(is_round ? mean_round_edge * (std::max)(spacing, Filling_stage::coarse_spacing)
                             : m_edge)
  {
    if(distances.empty()) return;
    const std::size_t outermost = distances.size() / 5;
    const auto last = distances.begin() + static_cast<std::ptrdiff_t>(outermost);
    std::nth_element(distances.begin(), last, distances.end());
    const double share = static_cast<double>(outermost) / static_cast<double>(distances.size());
    if(*last > 0) m_area = share * volume / *last;
  }

  double length(double thickness) const { return length(thickness, m_is_round); }

  // of the result
  double number_of_nodes(double thickness) const
  {
    return length(thickness) / (m_last_edge * thickness);
  }

  // on the way, at most: until its bends are rounded, a round filling is like any other
  double max_number_of_nodes(double thickness) const
  {
    return (std::max)(length(thickness, false) / (m_edge * thickness), number_of_nodes(thickness));
  }

  // with one thread
  double seconds(double thickness) const
  {
    return seconds_of_survey + (m_is_round ? seconds_per_round_node : seconds_per_node) *
                                   max_number_of_nodes(thickness);
  }

  // returns the thickness that leads to this largest number of nodes
  double thickness_with(double nodes) const
  {
    if(m_is_planar)
      return (std::max)(std::sqrt(planar_filling_density * m_volume / (m_edge * nodes)),
                        m_area / (2 * m_edge * nodes));
    const double density =
        (std::max)(filling_density / m_edge, m_is_round ? round_filling_density / m_last_edge : 0);
    return (std::max)(std::cbrt(density * m_volume / nodes),
                      std::sqrt(m_area / (4 * m_edge * nodes)));
  }

  // Throws std::invalid_argument if there would be more nodes than allowed. The message gives
  // lengths in the caller's unit.
  void check(double thickness, double most, double unit) const
  {
    const double nodes = max_number_of_nodes(thickness);
    if(!(nodes > most)) return;
    std::ostringstream demand;
    demand.imbue(std::locale::classic());
    demand.precision(3);
    demand << "the curve would have some " << nodes << " nodes, and take "
           << nodes * gigabytes_per_node << " GB; with " << unit * thickness_with(most)
           << " it has " << most << ", the most that are allowed"
           << (most < max_nodes ? " by default" : "");
    refuse_value(internal_np::thickness_t(), unit * thickness, demand.str());
  }

private:
  double length(double thickness, bool is_round) const
  {
    if(m_is_planar) return (std::max)(length_of_planar_filling(m_volume, thickness), m_area / 2);
    return (std::max)(length_of_filling(m_volume, thickness, is_round), m_area / (4 * thickness));
  }

  // In units of the shortest: on the domains of run_filling there are 3.6 to 3.7 nodes per r with
  // edges of at least 0.2 r.
  static constexpr double mean_edge = 1.37, mean_round_edge = 1.5;
  // The bunny with 949,000 nodes takes 131 s and 1.3 GB.
  static constexpr double gigabytes_per_node = 1.4e-6;
  // Fitted to the CPU time of 11 fillings, and of 10 round ones, of nine domains with 2,000 to
  // 49,000 nodes: they take 0.65 to 1.28 times as long (2026-11-26), and round ones, five of which
  // were measured again, 0.57 to 1.01 times (2026-11-28).
  static constexpr double seconds_of_survey = 0.3;
  static constexpr double seconds_per_node = 1.45e-4, seconds_per_round_node = 4.4e-4;

  bool m_is_planar, m_is_round;
  double m_volume, m_edge, m_last_edge; // edges in units of the thickness
  double m_area = 0;                    // of the boundary; its length in the plane
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_SIZE_H
