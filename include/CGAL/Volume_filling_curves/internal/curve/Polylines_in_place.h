// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_POLYLINES_IN_PLACE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_POLYLINES_IN_PLACE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Origin_interpolation.h>
#include <CGAL/Volume_filling_curves/internal/curve/network_of_polylines.h>
#include <CGAL/Volume_filling_curves/internal/polylines/Curve_paths.h>
#include <CGAL/Volume_filling_curves/internal/polylines/polyline_ranges.h>
#include <CGAL/Volume_filling_curves/internal/support/check_concepts.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Network made from one or more polylines, which the result of an algorithm replaces. The ends of
// open polylines are pinned, which keeps their knots. Items of polylines are points, or objects
// with a point that the point map reads and writes.
template <typename Polylines, typename NamedParameters>
class Polylines_in_place
{
  using Item = polyline_item_t<Polylines>;

  static_assert(std::is_class_v<Item>, "the items of polylines hold their points");
  static_assert(allows<Polylines&>([](auto& p) -> decltype(p.clear()) {}),
                "SequenceContainer requires clear(): the result replaces the polylines");

public:
  using Network = network_of_polylines_t<Polylines, NamedParameters>;

  Polylines_in_place(Polylines& polylines, const NamedParameters& np)
      : m_polylines(polylines), m_parameters(np), m_curves(polylines, np)
  {
    m_curves.pin_ends();
  }

  Network& curves() { return m_curves; }

  // Replaces the polylines by the current curves, and returns their origins on request.
  // \throws std::invalid_argument if a single polyline cannot hold several curves
  void store()
  {
    auto paths = Curve_paths(m_curves).paths;
    if(!is_range_of_ranges<Polylines> && paths.size() > 1) // an empty one, in a domain of parts
      throw std::invalid_argument("there are " + std::to_string(paths.size()) +
                                  " curves, one in each part of the domain, which do not fit into "
                                  "one polyline; pass a container of polylines");
    if(closure_of(m_parameters) == Closure::CLOSED)
      for(auto& path : paths) path.pop_back();
    const auto item = [&](std::size_t v) {
      Item result;
      put(point_map_of<Polylines>(m_parameters), result, m_curves.point(v));
      return result;
    };
    write(paths, item, m_polylines);
    store_origins(paths);
  }

private:
  void store_origins(const std::vector<std::vector<std::size_t>>& paths)
  {
    const auto target = CGAL::parameters::get_parameter(m_parameters, internal_np::origins);
    if constexpr(!std::is_same_v<std::decay_t<decltype(target)>,
                                 CGAL::internal_np::Param_not_found>) {
      const auto origins = Origin_interpolation<Network>(m_curves).origins();
      write(
          paths, [&](std::size_t v) { return origins[v]; }, unwrapped_target(target));
    }
  }

  template <typename Target>
  static Target& unwrapped_target(const std::reference_wrapper<Target>& target)
  {
    return target.get();
  }

  // Writes the values of a function for the nodes of each path. If it throws, nothing changes.
  template <typename Function, typename Container>
  static void write(const std::vector<std::vector<std::size_t>>& paths,
                    const Function& f,
                    Container& container)
  {
    Container written;
    if constexpr(is_range_of_ranges<Container>) {
      for(const auto& path : paths) {
        written.emplace_back();
        for(const std::size_t v : path) written.back().push_back(f(v));
      }
    } else if(!paths.empty()) {
      for(const std::size_t v : paths.front()) written.push_back(f(v));
    }
    container = std::move(written);
  }

  Polylines& m_polylines;
  const NamedParameters& m_parameters;
  Network m_curves;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_POLYLINES_IN_PLACE_H
