// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_NETWORK_RANGES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_NETWORK_RANGES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_topology.h>

#include <CGAL/Iterator_range.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/filter_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Ranges of a network: of indices, of indices without removed elements, and of the points of nodes.

using Index_range = Iterator_range<boost::counting_iterator<std::size_t>>;

inline Index_range index_range(std::size_t first, std::size_t past_the_end)
{
  using Iterator = Index_range::iterator;
  return {Iterator(first), Iterator(past_the_end)};
}

struct Is_present_node
{
  const Curve_topology* topology = nullptr;

  bool operator()(std::size_t v) const { return !topology->is_removed_node(v); }
};

struct Is_present_edge
{
  const Curve_topology* topology = nullptr;

  bool operator()(std::size_t e) const { return !topology->is_removed_edge(e); }
};

template <typename Is_present>
using Present_range =
    Iterator_range<boost::filter_iterator<Is_present, boost::counting_iterator<std::size_t>>>;

// the indices below `count` of present elements
template <typename Is_present>
Present_range<Is_present> present_range(Is_present is_present, std::size_t count)
{
  using Iterator = typename Present_range<Is_present>::iterator;
  const Index_range all = index_range(0, count);
  return {Iterator(is_present, all.begin(), all.end()), Iterator(is_present, all.end(), all.end())};
}

template <typename Point_3>
struct Point_of_node
{
  const std::vector<Point_3>* points = nullptr;

  const Point_3& operator()(std::size_t v) const { return (*points)[v]; }
};

template <typename Point_3>
using Point_range =
    Iterator_range<boost::transform_iterator<Point_of_node<Point_3>,
                                             typename Present_range<Is_present_node>::iterator>>;

template <typename Point_3>
Point_range<Point_3> point_range(const Present_range<Is_present_node>& nodes,
                                 const std::vector<Point_3>& points)
{
  using Iterator = typename Point_range<Point_3>::iterator;
  const Point_of_node<Point_3> point_of_node{&points};
  return {Iterator(nodes.begin(), point_of_node), Iterator(nodes.end(), point_of_node)};
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_NETWORK_RANGES_H
