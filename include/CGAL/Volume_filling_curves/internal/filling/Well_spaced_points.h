// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_WELL_SPACED_POINTS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_WELL_SPACED_POINTS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/search/Box_tree.h>
#include <CGAL/Volume_filling_curves/internal/search/Nearest_first_descent.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Well-spaced points inside a domain: they keep a distance, which may vary in space, from one
// another and from the boundary, and leave little space for more. Dart throwing (Cook 1986) over a
// finite set: candidates lie on a jittered grid, three per distance along each axis; in random
// order, each remaining one is taken and removes those within its distance. Near-linear in their
// number.
template <typename Domain, typename Traits, typename Distance>
class Well_spaced_points
{
  using Point_3 = typename Traits::Point_3;
  using Index = std::uint32_t;
  using Space = Space_of<Domain>;

public:
  // Takes the distance as a function of the point; the clearance, which is the share of it to keep
  // from the boundary; and the width of a layer along the boundary that is left out. A run that is
  // to stop finds no more points.
  Well_spaced_points(const Domain& domain,
                     const Distance& distance,
                     double clearance,
                     const Traits& traits,
                     Run_watch& watch,
                     double layer = 0)
      : m_domain(domain),
        m_distance(distance),
        m_clearance(clearance),
        m_traits(traits),
        m_watch(watch),
        m_layer(layer)
  {}

  // Returns points that also keep the distance from existing ones.
  std::vector<Vector> operator()(const std::vector<Vector>& existing, std::uint64_t seed)
  {
    Random_source random(seed);
    m_candidates.clear();
    m_is_kept.clear();
    find_candidates(random);
    if(m_watch.must_stop()) return {};
    const Box_tree tree(boxes_of_runs());
    m_is_struck_out.assign(m_candidates.size(), false);
    for(const Vector& p : existing) {
      if(m_watch.must_stop()) return {};
      strike_out_near(p, tree);
    }
    const std::vector<Index> order = shuffled(random);
    std::vector<Vector> points;
    for(const double clearance : {m_clearance, m_clearance / 2, m_clearance / 4}) // spikes last
      for(const Index k : order) {
        if(m_watch.must_stop()) return points;
        if(m_is_struck_out[k] || !has_clearance(m_candidates[k], clearance)) continue;
        points.push_back(m_candidates[k]);
        strike_out_near(m_candidates[k], tree);
      }
    return points;
  }

private:
  static constexpr double candidates_along_distance = 3;
  static constexpr int max_halvings = 20;                    // of the box
  static constexpr std::size_t max_candidates = 200'000'000; // 5 GB; a million nodes need a million
  static constexpr std::size_t max_cubes = 2'000'000'000;    // 8 GB; also those outside of the box
  // The content of the cube, in units of the box's. Candidates outside of larger boxes take little
  // time, and stay for the sake of the random order.
  static constexpr double min_cube_of_thin_box = 64;
  static constexpr std::size_t run_length = 16; // of candidates with a box for all of them

  struct Cube // or square
  {
    Vector low;
    double side;
  };

  // Divides a cube around the box down to the size required at each point, but not outside.
  void find_candidates(Random_source& random)
  {
    const CGAL::Bbox_3 box = m_domain.bbox();
    const Vector low(box.xmin(), box.ymin(), box.zmin());
    const Vector sides(box.x_span(), box.y_span(), box.z_span());
    double side = size_of_cube(low + sides / 2);
    while(side < sides.maxCoeff()) side *= 2;
    m_min_side = side * std::ldexp(1, -max_halvings);
    double cube = 1; // in units of the box
    for(int i = 0; i < Space::dimension; ++i) cube *= side / sides[i];
    m_is_thin = cube > min_cube_of_thin_box;
    divide({low, side}, random);
  }

  // Outside the domain's box, where the distance may not be defined, that of the nearest point of
  // the box.
  double size_of_cube(const Vector& p) const
  {
    const CGAL::Bbox_3 box = m_domain.bbox();
    const Vector q = p.cwiseMax({box.xmin(), box.ymin(), box.zmin()})
                         .cwiseMin({box.xmax(), box.ymax(), box.zmax()});
    return m_distance(to_point(q, m_traits)) / candidates_along_distance;
  }

  void divide(const Cube& cube, Random_source& random)
  {
    const Vector p = cube.low + cube.side * Space::random_point(random);
    constexpr double slack = 1 + 1e-9;
    if(cube.side <= slack * size_of_cube(p) || cube.side <= m_min_side)
      add_candidate(p);
    else if(!is_outside(cube) && !m_watch.must_stop())
      for(int k = 0; k < 1 << Space::dimension; ++k)
        divide({cube.low + cube.side / 2 * Vector(k % 2, k / 2 % 2, k / 4), cube.side / 2}, random);
  }

  // Candidates outside the domain's box, nearly all of those of a thin plate, are only counted, for
  // the random order.
  void add_candidate(const Vector& p)
  {
    if(m_candidates.size() == max_candidates || m_is_kept.size() == max_cubes)
      throw std::invalid_argument("thickness: it is too small for the domain, or for a part of it");
    m_is_kept.push_back(
        CGAL::do_overlap(m_domain.bbox(), Bbox_3(p.x(), p.y(), p.z(), p.x(), p.y(), p.z())));
    if(m_is_kept.back()) m_candidates.push_back(p);
  }

  // Outside, the distance to the boundary may be 0; the one to the box is not.
  bool is_outside(const Cube& cube) const
  {
    constexpr double half_diagonal = 0.87; // of a cube of side 1, rounded up
    const double radius = half_diagonal * cube.side;
    const Vector center = cube.low + cube.side / 2 * Space::ones();
    if(m_is_thin && squared_distance_to_box(center, m_domain.bbox()) > radius * radius) return true;
    const Point_3 p = to_point(center, m_traits);
    return !m_domain.is_inside(p) && m_domain.distance(p) > radius;
  }

  bool has_clearance(const Vector& x, double clearance) const
  {
    const Point_3 p = to_point(x, m_traits);
    return m_domain.is_inside(p) && m_domain.distance(p) - m_layer >= clearance * m_distance(p);
  }

  // Candidates that follow one another lie near each other, as the cubes do.
  std::vector<Bbox_3> boxes_of_runs() const
  {
    std::vector<Bbox_3> boxes((m_candidates.size() + run_length - 1) / run_length);
    for(std::size_t k = 0; k < m_candidates.size(); ++k) {
      const Vector& p = m_candidates[k];
      boxes[k / run_length] += Bbox_3(p.x(), p.y(), p.z(), p.x(), p.y(), p.z());
    }
    return boxes;
  }

  void strike_out_near(const Vector& p, const Box_tree& tree)
  {
    Strike query{*this, p, m_distance(to_point(p, m_traits))};
    Nearest_first_descent<Strike>(tree, query).run();
  }

  // Strikes out the candidates within a distance of a point.
  struct Strike
  {
    Well_spaced_points& points;
    Vector center;
    double distance;

    double entry(const Bbox_3& box) const { return squared_distance_to_box(center, box); }

    double bound() const
    {
      constexpr double slack = 1 + 1e-9; // for the rounding of distances to boxes
      return slack * distance * distance;
    }

    void visit(std::size_t run)
    {
      const auto& candidates = points.m_candidates;
      const std::size_t end = (std::min)((run + 1) * run_length, candidates.size());
      for(std::size_t k = run * run_length; k < end; ++k)
        if((candidates[k] - center).squaredNorm() <= distance * distance)
          points.m_is_struck_out[k] = true;
    }
  };

  // The indices of the candidates in random order; none if the run is to stop.
  std::vector<Index> shuffled(Random_source& random) const
  {
    constexpr Index none = (std::numeric_limits<Index>::max)();
    std::vector<Index> order(m_is_kept.size());
    Index number = 0;
    for(std::size_t k = 0; k < order.size(); ++k) {
      if(k % 65536 == 0 && m_watch.must_stop()) return {};
      const std::size_t j = random.index(k + 1);
      order[k] = order[j];
      order[j] = m_is_kept[k] ? number++ : none;
    }
    order.erase(std::remove(order.begin(), order.end(), none), order.end());
    return order;
  }

  const Domain& m_domain;
  const Distance& m_distance;
  const double m_clearance; // from the boundary, in units of the distance
  const Traits m_traits;
  Run_watch& m_watch;
  const double m_layer;
  double m_min_side = 0;
  bool m_is_thin = false;          // whether nearly all of the cube lies outside of the box
  std::deque<Vector> m_candidates; // no vector, which takes thrice as much while it grows
  std::vector<bool> m_is_kept;     // of all candidates, in the order of the cubes
  std::vector<bool> m_is_struck_out;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_WELL_SPACED_POINTS_H
