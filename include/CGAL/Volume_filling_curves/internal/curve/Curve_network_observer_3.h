// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_NETWORK_OBSERVER_3_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_NETWORK_OBSERVER_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/Isotopy_guard_3.h
 *
 * \brief The class `Curve_network_observer_3` is the base of classes that follow the changes of a
 * `Curve_network_3`.
 *
 * Its functions are called right after each change, so that data of your own about nodes and edges
 * stay in step. By default they do nothing.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \sa `Isotopy_guard_3::add_observer()`
 */
template <typename Traits = Curve_flow_traits_3<>>
class Curve_network_observer_3
{
public:
  /// the type of points
  using Point_3 = typename Traits::Point_3;

  /// the type of the indices of nodes and edges
  using size_type = std::size_t;

  /// A motion of all nodes. In each round, the nodes go to their new positions one after another.
  struct Rounds
  {
    std::vector<std::vector<Point_3>> positions; ///< one vector per round, one position per node
    bool is_reversed = false; ///< whether the node with the largest index is the first to move
  };

  /// node `v` has moved to where it is now.
  virtual void on_move(size_type /* v */) {}

  /// all nodes have moved, from the positions `before` to where they are now.
  virtual void on_motion(const std::vector<Point_3>& /* before */, const Rounds& /* rounds */) {}

  /// the new last node `v` splits an edge. Its edge 0 has the index and the source of that edge,
  /// its edge 1 is the new last edge.
  virtual void on_insertion(size_type /* v */) {}

  /// node `v` is gone, and edge `e` joins its two neighbors.
  virtual void on_removal(size_type /* v */, size_type /* e */) {}

  /// the new last node `v` is the tip of a ray, with the new last edge. See
  /// `Isotopy_guard_3::add_ray()`.
  virtual void on_new_ray(size_type /* v */) {}

  /// node `v` of a ray is gone, and so is its edge `e`.
  virtual void on_shorter_ray(size_type /* v */, size_type /* e */) {}

  /// nodes and edges are numbered along the curve again: node `v` had the index `former[v]`.
  virtual void on_renumbering(const std::vector<std::uint32_t>& /* former */) {}

protected:
  ~Curve_network_observer_3() = default;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_NETWORK_OBSERVER_3_H
