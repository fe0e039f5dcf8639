// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_MEDIAL_SPHERE_SEARCH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_MEDIAL_SPHERE_SEARCH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/domain_concepts.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Boundary_limit.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Medial_spheres.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Moving_neighborhood.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Node_list.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Node_neighborhoods.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Support_function.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Search for the medial spheres of a curve: neighbors of the nodes -> support function of their
// images under inversion -> radii. (The paper bisects each radius, with a query for the nearest
// node at every step.) One visit of the nodes within reach of a node's largest sphere serves all of
// its directions. The size of this sphere is known closely beforehand: the nodes that the spheres
// of the preceding node touch are also obstacles here, and the boundary limits the spheres before
// the nodes do. None of this changes the result: the spheres of a node have the same bits in a
// query for this node alone.
//
// If r_max is much larger than the thickness, as while a curve fills a volume, most spheres are
// still small. They are first searched with a small cap, which is doubled for nodes with a sphere
// that reaches it.
template <typename ConcurrencyTag>
class Medial_sphere_search
{
  using Index = Medial_spheres::Index;
  using Circles = std::vector<std::size_t>;

public:
  // Takes the positions of the nodes, the thickness at each, and the cap of the radii in units of
  // the thickness. The search is under a watch, if there is one.
  Medial_sphere_search(ConcurrencyTag,
                       const Vector_field& x,
                       const std::vector<double>& thickness,
                       double max_radius,
                       Sphere_limit boundary_limit = {},
                       Run_watch* watch = nullptr)
      : m_x(x),
        m_thickness(thickness),
        m_max_radius(max_radius),
        m_boundary_limit(std::move(boundary_limit)),
        m_watch(watch),
        m_neighborhoods(x)
  {}

  // Takes the circles of all nodes, in the order of the nodes. \pre number_of_directions > 0
  // \throws Run_stopped
  Medial_spheres operator()(std::vector<Node_circle> circles, std::size_t number_of_directions)
  {
    m_spheres = Medial_spheres(std::move(circles), number_of_directions);
    Circles open(m_spheres.circles().size()); // those with spheres that have no radius yet
    std::iota(open.begin(), open.end(), 0);
    for_each_sphere(open, [&](std::size_t c, std::size_t l) { set(c, l, 0, still_open); });
    for(double last_cap = 0; last_cap < m_max_radius && !open.empty();) {
      const double cap = (std::min)((std::max)(first_cap, cap_growth * last_cap), m_max_radius);
      find_radii(open, last_cap, cap);
      const auto is_done = [&](std::size_t c) { return !has_open_sphere(c); };
      open.erase(std::remove_if(open.begin(), open.end(), is_done), open.end());
      last_cap = cap;
    }
    for_each_sphere(open, [&](std::size_t c, std::size_t l) {
      if(is_open(c, l)) set(c, l, m_spheres.radius(c, l), Medial_spheres::no_node);
    });
    return std::move(m_spheres);
  }

private:
  // In units of the thickness. 1.2 and 1.5 take 30 % longer to fill the bunny (2026-11-21).
  static constexpr double first_cap = 2, cap_growth = 2;
  static constexpr std::size_t block = 256;

  // stands for the touching node of a sphere that touches nothing up to the cap tried last
  static constexpr Index still_open = Medial_spheres::no_node - 1;

  bool is_open(std::size_t c, std::size_t l) const
  {
    return m_spheres.touching_node(c, l) == still_open;
  }

  bool has_open_sphere(std::size_t c) const
  {
    for(std::size_t l = 0; l < m_spheres.number_of_directions(); ++l)
      if(is_open(c, l)) return true;
    return false;
  }

  void set(std::size_t c, std::size_t l, double radius, Index touching_node)
  {
    m_spheres.set(c, l, radius, touching_node);
  }

  template <typename Function>
  void for_each_sphere(const Circles& circles, const Function& f) const
  {
    for(std::size_t c : circles)
      for(std::size_t l = 0; l < m_spheres.number_of_directions(); ++l) f(c, l);
  }

  Vector position(std::size_t c) const { return row(m_x, m_spheres.circles()[c].node); }
  double thickness(std::size_t c) const { return m_thickness[m_spheres.circles()[c].node]; }

  // Data that consecutive circles share.
  struct Workspace
  {
    Support_function support;
    Moving_neighborhood neighborhood;
    Node_list touched;                // by the spheres of the last circle
    Planar_rays paths;                // of the centers, up to the boundary
    std::vector<double> free_lengths; // of the paths, without the boundary
  };

  // Finds the radii of some circles that are below a cap, in units of the thickness.
  void find_radii(const Circles& circles, double last_cap, double cap)
  {
    const auto find_in_block = [&](std::size_t begin, std::size_t end) {
      Workspace work{Support_function(m_spheres.directions()),
                     Moving_neighborhood(m_neighborhoods),
                     {},
                     {},
                     {}};
      for(; begin < end; ++begin) find_radii(circles[begin], last_cap, cap, work);
    };
    for_each_block<ConcurrencyTag>(circles.size(), block, m_watch, find_in_block);
  }

  void find_radii(std::size_t c, double last_cap, double cap, Workspace& work)
  {
    constexpr double slack = 1 + 1e-12; // rounding
    const double unit = thickness(c);
    start(c, cap, work);
    if(work.touched.size() > 0) work.support.add(work.touched);
    limit_paths(c, cap, work);
    const double diameter = slack * 2 * unit / work.support.least();
    const Vector normal = m_spheres.circles()[c].normal();
    work.support.add(work.neighborhood(position(c), normal, diameter));
    for(std::size_t l = 0; l < m_spheres.number_of_directions(); ++l)
      if(is_open(c, l)) set_radius(c, l, cap, work);
    note_touched(cap, work);
    if(m_boundary_limit) m_boundary_limit.limit_spheres(m_spheres, c, last_cap * unit);
  }

  void start(std::size_t c, double cap, Workspace& work) const
  {
    work.support.start(position(c), m_spheres.circles()[c], thickness(c));
    for(std::size_t l = 0; l < m_spheres.number_of_directions(); ++l)
      if(is_open(c, l))
        work.support.bound(l, 1 / cap);
      else
        work.support.close(l);
  }

  // Finds how far centers can go before they meet the boundary, if they do so before their spheres
  // meet one of the nodes touched last.
  void limit_paths(std::size_t c, double cap, Workspace& work) const
  {
    constexpr double slack = 1 - 1e-15; // rounding: a sphere of that radius touches no node
    const double unit = thickness(c);
    std::vector<double>& lengths = work.paths.lengths;
    lengths.assign(m_spheres.number_of_directions(), cap * unit);
    if(m_boundary_limit) {
      for(std::size_t l = 0; l < lengths.size(); ++l)
        if(!is_open(c, l))
          lengths[l] = 0;
        else if(work.support.is_supported(l))
          lengths[l] = unit / work.support(l);
      work.free_lengths = lengths;
      m_boundary_limit.limit_centers(m_spheres, c, work.paths);
      for(std::size_t l = 0; l < lengths.size(); ++l)
        if(lengths[l] < work.free_lengths[l])
          work.support.bound(l, slack * unit / lengths[l]);
        else
          lengths[l] = cap * unit;
    }
  }

  void set_radius(std::size_t c, std::size_t l, double cap, const Workspace& work)
  {
    const double unit = thickness(c), limit = work.paths.lengths[l];
    const double radius = work.support.is_supported(l) ? unit / work.support(l) : limit;
    if(work.support.is_supported(l) && radius <= limit)
      set(c, l, radius, work.support.supporting_node(l));
    else
      set(c, l, limit, limit < cap * unit ? Medial_spheres::no_node : still_open);
  }

  // If a sphere reaches the cap, knowing the nodes that others touch gains nothing.
  void note_touched(double cap, Workspace& work) const
  {
    work.touched.clear();
    if(work.support.least() <= 1 / cap) return;
    Index last = Medial_spheres::no_node;
    for(std::size_t l = 0; l < m_spheres.number_of_directions(); ++l) {
      if(!work.support.is_supported(l) || work.support.supporting_node(l) == last) continue;
      last = work.support.supporting_node(l);
      work.touched.push_back(last, row(m_x, last));
    }
  }

  const Vector_field& m_x;
  const std::vector<double>& m_thickness;
  double m_max_radius;
  Sphere_limit m_boundary_limit;
  Run_watch* m_watch; // none if null
  Node_neighborhoods m_neighborhoods;
  Medial_spheres m_spheres;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_MEDIAL_SPHERE_SEARCH_H
