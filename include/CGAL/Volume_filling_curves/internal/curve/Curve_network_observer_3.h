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
 * \brief The class `Curve_network_observer_3` is the base class of observers of a
 * `Curve_network_3`.
 *
 * Its functions are called right after each change, which keeps your own data about nodes and edges
 * up to date. By default they do nothing.
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

  /// A motion of all nodes. In each round, the nodes move to their new positions one after another.
  struct Rounds
  {
    std::vector<std::vector<Point_3>> positions; ///< one vector per round, one position per node
    bool is_reversed = false; ///< whether the node with the largest index moves first
  };

  /// is called after node `v` has moved to its present position.
  virtual void on_move(size_type /* v */) {}

  /// is called after all nodes have moved from the positions `before` to their present ones.
  virtual void on_motion(const std::vector<Point_3>& /* before */, const Rounds& /* rounds */) {}

  /// is called after the new last node `v` has split an edge. Its edge 0 has the index and the
  /// source of that edge; its edge 1 is the new last edge.
  virtual void on_insertion(size_type /* v */) {}

  /// is called after node `v` has been removed and edge `e` joins its two neighbors.
  virtual void on_removal(size_type /* v */, size_type /* e */) {}

  /// is called after a ray has been added, with the new last node `v` as its tip and the new last
  /// edge. See `Isotopy_guard_3::add_ray()`.
  virtual void on_new_ray(size_type /* v */) {}

  /// is called after node `v` of a ray and its edge `e` have been removed.
  virtual void on_shorter_ray(size_type /* v */, size_type /* e */) {}

  /// is called after nodes and edges have been renumbered along the curve: node `v` had the index
  /// `former[v]`.
  virtual void on_renumbering(const std::vector<std::uint32_t>& /* former */) {}

protected:
  ~Curve_network_observer_3() = default;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_NETWORK_OBSERVER_3_H
