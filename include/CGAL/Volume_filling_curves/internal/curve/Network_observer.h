// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_NETWORK_OBSERVER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_NETWORK_OBSERVER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Is told of every change of a network right after it, once it is registered with the network's
// editor, so that what belongs to the network (an index, a record) follows it by itself.
template <typename Network>
class Network_observer
{
public:
  using Point_3 = typename Network::Point_3;

  // A motion of all nodes: in each round they go to their new places one after another, in the
  // order of their indices or in reverse order.
  struct Rounds
  {
    std::vector<std::vector<Point_3>> positions; // one vector per round
    bool is_reversed = false;                    // whether the last node is the first to move
  };

  // Node v went to where it is now.
  virtual void on_move(std::size_t v) = 0;

  // All nodes went from where they were, `before`, to where they are now.
  virtual void on_motion(const std::vector<Point_3>& before, const Rounds& rounds) = 0;

  // The new last node v splits an edge: its edge 0 has the index that the edge had, and the source;
  // its edge 1 is the new last one.
  virtual void on_insertion(std::size_t v) = 0;

  // Node v is gone, and edge e joins its two neighbors.
  virtual void on_removal(std::size_t v, std::size_t e) = 0;

  // The new last node v is a leaf, a node with one edge, that was added to the network.
  virtual void on_new_leaf(std::size_t v) = 0;

  // Node v has the index that former[v] had.
  virtual void on_renumbering(const std::vector<std::uint32_t>& former) = 0;

protected:
  ~Network_observer() = default;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_NETWORK_OBSERVER_H
