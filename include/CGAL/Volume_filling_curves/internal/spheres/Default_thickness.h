// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_DEFAULT_THICKNESS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_DEFAULT_THICKNESS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Medial_sphere_search.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Default thickness for untangling: the 25th percentile of a curve's medial radii over all (node,
// direction) pairs, where spheres that touch nothing count as infinite. It is independent of scale,
// and of the division into edges, since the curve is sampled at a fifth of the result. (The median
// jams Freedman-He-Wang's unknot, the 35th percentile some trefoils.) The limited number of samples
// keeps nearly coincident strands from making it arbitrarily small. At junctions strands are close
// whatever the thickness; networks of many nodes therefore get at most about four times as many
// (one of 2,146 nodes got 22,253). Near-linear time: the cap of the radii grows from the samples'
// spacing until a quarter of the spheres touch.
template <typename Network, typename ConcurrencyTag>
class Default_thickness
{
public:
  Default_thickness(const Network& curve,
                    std::size_t number_of_directions,
                    Run_watch* watch = nullptr)
      : m_curve(curve),
        m_x(coordinates(curve)),
        m_number_of_directions(number_of_directions),
        m_watch(watch)
  {}

  // Returns a length, 0 for a curve smaller than 1e-150. \throws Run_stopped
  double operator()()
  {
    const double diagonal = box_diagonal();
    if(!(diagonal >= min_extent)) return 0; // lengths of edges would underflow
    double thickness = first_guess * diagonal;
    for(int k = 0; k < max_refinements && thickness > 0; ++k) {
      sample(samples_per_thickness * thickness);
      const double least = (std::min)(min_thickness(), thickness);
      const double refined = (std::max)(percentile(thickness), least);
      const bool is_settled = refined > settled * thickness;
      thickness = refined;
      if(is_settled) break;
    }
    return thickness;
  }

private:
  static constexpr double percentage = 0.25;
  static constexpr double first_guess = 0.1;           // of the box diagonal
  static constexpr double samples_per_thickness = 0.2; // spacing over thickness
  // Every third sample is measured: its neighbors have almost its radii. Over 31 curves that takes
  // half of the time and changes the thickness by 1.4 % at most, 0.5 % in the mean (2026-11-23).
  static constexpr std::size_t measured_sample = 3;
  static constexpr double settled = 0.98;
  static constexpr int max_refinements = 8;
  static constexpr double growth = 4, coarse = 500;  // of a network's number of nodes
  static constexpr double edge_per_thickness = 0.28; // mean; edges are between 0.2 and 0.4
  static constexpr double max_samples = 1e5, max_samples_per_node = 10; // together

  double box_diagonal() const { return m_x.rows() == 0 ? 0 : sides(m_x).norm(); }

  // Nodes first, then points inside the edges.
  void sample(double spacing)
  {
    m_circles = node_circles(m_curve, m_x);
    std::vector<Vector> samples;
    for(std::size_t e = 0; e < m_curve.number_of_edges(); ++e) {
      const Vector a = row(m_x, m_curve.source(e)), b = row(m_x, m_curve.target(e));
      const double length = (b - a).norm(), pieces = std::ceil(length / spacing);
      for(double k = 1; k < pieces; ++k) {
        m_circles.emplace_back(m_curve.number_of_nodes() + samples.size(), (b - a) / length, 1.);
        samples.push_back(a + k / pieces * (b - a));
      }
    }
    m_samples.resize(m_x.rows() + static_cast<Eigen::Index>(samples.size()), 3);
    m_samples.topRows(m_x.rows()) = m_x;
    for(std::size_t k = 0; k < samples.size(); ++k)
      set_row(m_samples, m_x.rows() + static_cast<Eigen::Index>(k), samples[k]);
    thin_out_circles();
  }

  void thin_out_circles()
  {
    std::size_t count = 0;
    for(std::size_t c = 0; c < m_circles.size(); c += measured_sample)
      m_circles[count++] = m_circles[c];
    m_circles.erase(m_circles.begin() + static_cast<std::ptrdiff_t>(count), m_circles.end());
  }

  // At most `largest`. No cap between half of `largest` and `largest` is tried: at the end the
  // thickness hardly falls, and most radii would reach the smaller cap.
  double percentile(double largest) const
  {
    for(double cap = start_cap();; cap *= 2) {
      if(2 * cap > largest) cap = largest;
      const std::vector<double> caps(static_cast<std::size_t>(m_samples.rows()), cap);
      Medial_sphere_search search(ConcurrencyTag(), m_samples, caps, 1., Sphere_limit(), m_watch);
      const Medial_spheres spheres = search(m_circles, m_number_of_directions);
      std::vector<double> radii;
      for(std::size_t c = 0; c < m_circles.size(); ++c)
        for(std::size_t l = 0; l < m_number_of_directions; ++l)
          radii.push_back(spheres.radius(c, l));
      const auto rank = static_cast<std::ptrdiff_t>(percentage * static_cast<double>(radii.size()));
      std::nth_element(radii.begin(), radii.begin() + rank, radii.end());
      if(radii[static_cast<std::size_t>(rank)] < cap || cap == largest)
        return radii[static_cast<std::size_t>(rank)];
    }
  }

  // four times the mean distance of samples along the curve
  double start_cap() const { return 4 * length() / static_cast<double>(m_samples.rows()); }

  double min_thickness() const
  {
    const auto n = static_cast<double>(m_x.rows());
    const double samples = max_samples + max_samples_per_node * n;
    const double least = length() / (samples_per_thickness * samples);
    if(!m_curve.has_junction()) return least;
    const double max_nodes = growth * (std::max)(n, coarse);
    return (std::max)(least, length() / (edge_per_thickness * max_nodes));
  }

  double length() const
  {
    double sum = 0;
    for(double weight : node_weights(m_curve, m_x)) sum += weight;
    return sum;
  }

  const Network& m_curve;
  Vector_field m_x, m_samples;
  std::size_t m_number_of_directions;
  Run_watch* m_watch; // none if null
  std::vector<Node_circle> m_circles;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_DEFAULT_THICKNESS_H
