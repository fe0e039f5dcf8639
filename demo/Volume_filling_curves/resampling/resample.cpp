// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "resampling/resample.h"

#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;
using curves::internal::to_vector;
using Vector_3 = curves::internal::Vector;
using Guard = curves::Isotopy_guard_3<>;
using Strand = curves::internal::Curve_strand;

constexpr double max_number_of_nodes = 2e7; // as for fillings
constexpr double min_gap = 1e-9; // of the step: a node that near to a new one takes its place

// A node of a strand, former or new.
struct Station
{
  std::size_t node;
  Vector_3 position;
  bool stays;
};

using Stations = std::vector<Station>;

Vector_3 position(const Guard& guard, std::size_t v)
{
  return to_vector(guard.curve().point(v));
}

double length_of(const Guard& guard, const Strand& strand)
{
  double length = 0;
  for(const std::size_t e : strand.edges)
    length += curves::internal::edge_vector(guard.curve(), e).norm();
  return length;
}

// A part of a strand: an edge, and the lengths along the strand at which it begins and ends.
struct Part
{
  std::size_t edge;
  Vector_3 begin, end;
  double from, to;
};

// Inserts the new nodes that lie in a part. Of an edge that is divided, the half at the source
// keeps the index; so the nodes that are far from it come first.
Stations insert_in_part(Guard& guard, const Part& part, double step)
{
  const auto& curve = guard.curve();
  const double gap = min_gap * step;
  std::vector<double> places;
  for(double k = std::floor((part.from + gap) / step) + 1; k * step < part.to - gap; ++k)
    places.push_back((k * step - part.from) / (part.to - part.from));
  const bool is_forward = to_vector(curve.point(curve.source(part.edge))) == part.begin;
  if(is_forward) std::reverse(places.begin(), places.end());
  Stations inserted;
  for(const double place : places) {
    const Vector_3 p = part.begin + place * (part.end - part.begin);
    if(guard.insert_node(part.edge, {p.x(), p.y(), p.z()}))
      inserted.push_back({curve.target(part.edge), p, true});
  }
  if(is_forward) std::reverse(inserted.begin(), inserted.end());
  return inserted;
}

// Inserts the new nodes of a strand.
Stations insert_in_strand(Guard& guard, const Strand& strand, double spacing)
{
  const double length = length_of(guard, strand), least = strand.is_closed ? 3 : 1;
  const double step = length / (std::max)(least, std::round(length / spacing));
  Stations stations = {{strand.nodes.front(), position(guard, strand.nodes.front()), true}};
  Part part{0, {}, stations.front().position, 0, 0};
  for(std::size_t i = 0; i < strand.edges.size(); ++i) {
    const std::size_t v = strand.nodes[i + 1];
    part = {strand.edges[i], part.end, position(guard, v), part.to, part.to};
    part.to += (part.end - part.begin).norm();
    for(const Station& station : insert_in_part(guard, part, step)) stations.push_back(station);
    const bool is_due = std::abs(part.to - step * std::round(part.to / step)) <= min_gap * step;
    stations.push_back({v, part.end, is_due || i + 1 == strand.edges.size()});
  }
  return stations;
}

// Removes the former nodes, in rounds: one that was in the way of another may be gone.
void remove_former_nodes(Guard& guard, const std::vector<Stations>& all)
{
  for(bool has_removed = true; has_removed;) {
    has_removed = false;
    for(const Stations& stations : all)
      for(const Station& station : stations)
        if(!station.stays && !guard.curve().is_removed_node(station.node))
          has_removed |= guard.remove_node(station.node);
  }
}

// Measures a strand: a removed node is at most as far from the new curve as from the edge that took
// its place, and no point of that edge is farther from the former curve than such a node.
void measure(const Guard& guard, const Stations& stations, Resampling& result)
{
  std::size_t last = 0;
  for(std::size_t i = 1; i < stations.size(); ++i) {
    if(guard.curve().is_removed_node(stations[i].node)) continue;
    const Vector_3 &a = stations[last].position, &b = stations[i].position;
    for(std::size_t k = last + 1; k < i; ++k)
      result.max_distance = (std::max)(
          result.max_distance,
          std::sqrt(curves::internal::squared_distance_to_segment(stations[k].position, a, b)));
    const double length = (b - a).norm();
    result.min_spacing = (std::min)(result.min_spacing, length);
    result.max_spacing = (std::max)(result.max_spacing, length);
    if(!stations[i].stays) ++result.number_of_kept_nodes;
    last = i;
  }
}

} // namespace

Resampling resample(Curve& curve, double spacing)
{
  if(curves::length(curve) > max_number_of_nodes * spacing)
    throw std::invalid_argument("the curve would have more than 20 million nodes");
  Resampling result;
  result.min_spacing = std::numeric_limits<double>::infinity();
  {
    Guard guard(curve);
    std::vector<Stations> all;
    for(const Strand& strand : curves::internal::strands(curve))
      all.push_back(insert_in_strand(guard, strand, spacing));
    remove_former_nodes(guard, all);
    for(const Stations& stations : all) measure(guard, stations, result);
    guard.collect_garbage();
  }
  return result;
}

} // namespace vfc
