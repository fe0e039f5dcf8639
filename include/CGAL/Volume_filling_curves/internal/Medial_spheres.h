// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEDIAL_SPHERES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEDIAL_SPHERES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Node_neighborhoods.h>
#include <CGAL/Volume_filling_curves/internal/cos_sin.h>
#include <CGAL/Volume_filling_curves/internal/for_each_block.h>
#include <CGAL/Volume_filling_curves/internal/node_circles.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// What else than other nodes limits medial spheres: nothing.
struct No_wall_limit
{
  static constexpr bool is_active = false;
};

// The medial spheres of a curve (section 3.2 of the paper): for each node and each of N directions
// orthogonal to the curve the largest sphere, up to a cap, that touches the node with its centre in
// that direction and holds no other node.
//
// Inverting the other nodes at the node i turns the search into a support function,
//   1 / R(i, l) = max(1 / r_max, max over j of 2 x_l . d_j / |d_j|^2),  d_j = node_j - node_i,
// so that one query for the nodes within 2 r_max serves all directions. Runs of consecutive nodes,
// which lie close together, share a query. Where r_max is much larger than the thickness, as while a
// curve fills a volume, most spheres are not: they are sought with a small cap first, which is doubled
// for the nodes with a sphere that reaches it.
class Medial_spheres
{
public:
  using Index = std::uint32_t;
  static constexpr Index no_node = static_cast<Index>(-1);

  Medial_spheres() = default;

  // Takes the circles of all nodes, in the order of the nodes, the nodes' thicknesses, the cap of the
  // radii in units of the thickness, and what the walls leave of the radii.
  // \pre number_of_directions > 0
  template <typename ConcurrencyTag, typename WallLimit = No_wall_limit>
  Medial_spheres(ConcurrencyTag,
                 const Vector_field& x,
                 std::vector<Node_circle> circles,
                 std::size_t number_of_directions,
                 const std::vector<double>& thickness,
                 double max_radius,
                 const WallLimit& wall_limit = WallLimit())
      : m_circles(std::move(circles)),
        m_radius(m_circles.size() * number_of_directions),
        m_touching(m_circles.size() * number_of_directions, open_sphere)
  {
    for(std::size_t l = 0; l < number_of_directions; ++l) {
      const auto [cosine, sine] =
          cos_sin(static_cast<double>(l) / static_cast<double>(number_of_directions));
      m_cosine.push_back(cosine);
      m_sine.push_back(sine);
    }
    const Node_neighborhoods neighborhoods(x);
    std::vector<std::size_t> open(m_circles.size()); // circles with a sphere that has no radius yet
    std::iota(open.begin(), open.end(), 0);
    for(double last_cap = 0; last_cap < max_radius && !open.empty();) {
      const double cap = (std::min)((std::max)(first_cap, cap_growth * last_cap), max_radius);
      measure<ConcurrencyTag>(x, neighborhoods, open, thickness, cap);
      limit_by_walls<ConcurrencyTag>(open, wall_limit, thickness, last_cap);
      last_cap = cap;
      const auto is_done = [&](std::size_t c) { return !has_open_sphere(c); };
      open.erase(std::remove_if(open.begin(), open.end(), is_done), open.end());
    }
    std::replace(m_touching.begin(), m_touching.end(), open_sphere, no_node);
  }

  std::size_t number_of_directions() const { return m_cosine.size(); }
  const std::vector<Node_circle>& circles() const { return m_circles; }

  // the first circle of node v, or of the nodes after it if it has none
  std::size_t first_circle(std::size_t v) const
  {
    const auto found = std::lower_bound(
        m_circles.begin(), m_circles.end(), v,
        [](const Node_circle& circle, std::size_t node) { return circle.node < node; });
    return static_cast<std::size_t>(found - m_circles.begin());
  }

  // the direction l of circle c, a unit vector
  Vector direction(std::size_t c, std::size_t l) const
  {
    return m_cosine[l] * m_circles[c].u + m_sine[l] * m_circles[c].v;
  }

  double radius(std::size_t c, std::size_t l) const
  {
    return m_radius[c * number_of_directions() + l];
  }

  // the node that the sphere touches, no_node if its radius is the cap
  Index touching_node(std::size_t c, std::size_t l) const
  {
    return m_touching[c * number_of_directions() + l];
  }

private:
  // In units of the thickness. 1.2 and 1.5 take 30 % longer to fill the bunny (2026-11-21).
  static constexpr double first_cap = 2, cap_growth = 2;
  static constexpr Index open_sphere = no_node - 1; // touches nothing up to the cap tried last
  static constexpr std::size_t block = 256;

  // Nodes near a run, their images under inversion at a node, projected to the plane of its circle in
  // units of 1 / cap, and the support function of these. An array for each coordinate, so that
  // loops take several at a time.
  struct Workspace
  {
    std::vector<Index> nodes;
    std::vector<double> x, y, z;
    std::vector<double> u, v, squared_norm;
    std::vector<double> support;          // per direction
    std::vector<std::int64_t> supporting; // per direction, place of the node in `nodes`
  };

  // Measures the spheres of some circles, up to a cap in units of the thickness.
  template <typename ConcurrencyTag>
  void measure(const Vector_field& x,
               const Node_neighborhoods& neighborhoods,
               const std::vector<std::size_t>& circles,
               const std::vector<double>& thickness,
               double cap)
  {
    const auto cap_of = [&](std::size_t k) { return cap * thickness[m_circles[circles[k]].node]; };
    for_each_block<ConcurrencyTag>(circles.size(), block, [&](std::size_t begin, std::size_t end) {
      Workspace workspace;
      while(begin < end) {
        const std::size_t run_end =
            find_run(x, neighborhoods, circles, begin, end, cap_of, workspace);
        load(x, workspace);
        for(; begin < run_end; ++begin)
          measure_circle(row(x, m_circles[circles[begin]].node), circles[begin], cap_of(begin),
                         workspace);
      }
    });
  }

  // Finds the nodes near a run of circles from `begin` on, and returns where the run ends.
  template <typename CapOf>
  std::size_t find_run(const Vector_field& x,
                       const Node_neighborhoods& neighborhoods,
                       const std::vector<std::size_t>& circles,
                       std::size_t begin,
                       std::size_t end,
                       const CapOf& cap_of,
                       Workspace& workspace) const
  {
    constexpr std::size_t longest_run = 16; // 8 is as fast
    const Vector first = row(x, m_circles[circles[begin]].node);
    Vector low = first, high = first;
    double cap = cap_of(begin);
    std::size_t run_end = begin + 1;
    for(; run_end < end && run_end < begin + longest_run; ++run_end) {
      const Vector p = row(x, m_circles[circles[run_end]].node);
      if((p - first).squaredNorm() > cap * cap) break;
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
      cap = (std::max)(cap, cap_of(run_end));
    }
    const double slack = 1 + 1e-12; // rounding of the centre
    neighborhoods.find((low + high) / 2, slack * ((high - low).norm() / 2 + 2 * cap),
                       workspace.nodes);
    return run_end;
  }

  bool is_open(std::size_t c, std::size_t l) const { return touching_node(c, l) == open_sphere; }

  bool has_open_sphere(std::size_t c) const
  {
    for(std::size_t l = 0; l < number_of_directions(); ++l)
      if(is_open(c, l)) return true;
    return false;
  }

  template <typename ConcurrencyTag, typename WallLimit>
  void limit_by_walls(const std::vector<std::size_t>& circles,
                      const WallLimit& wall_limit,
                      const std::vector<double>& thickness,
                      double last_cap)
  {
    if constexpr(WallLimit::is_active)
      for_each_block<ConcurrencyTag>(
          circles.size(), block, [&](std::size_t begin, std::size_t end) {
            for(; begin < end; ++begin) {
              const std::size_t c = circles[begin];
              limit_by_walls(c, wall_limit, last_cap * thickness[m_circles[c].node]);
            }
          });
  }

  // Radii below the cap tried last have been limited already.
  template <typename WallLimit>
  void limit_by_walls(std::size_t c, const WallLimit& wall_limit, double last_cap)
  {
    const std::size_t n = number_of_directions(), node = m_circles[c].node;
    double largest = 0;
    for(std::size_t l = 0; l < n; ++l) largest = (std::max)(largest, radius(c, l));
    constexpr double slack = 1 - 1e-9; // rounding of radii
    const double least = (std::max)(wall_limit.free_radius(node, largest), slack * last_cap);
    for(std::size_t l = 0; l < n; ++l) {
      if(radius(c, l) < least) continue;
      const double limited = wall_limit(node, direction(c, l), radius(c, l));
      if(!(limited < radius(c, l))) continue;
      m_radius[c * n + l] = limited;
      m_touching[c * n + l] = no_node;
    }
  }

  static void load(const Vector_field& x, Workspace& workspace)
  {
    const std::size_t n = workspace.nodes.size();
    for(auto* values : {&workspace.x, &workspace.y, &workspace.z, &workspace.u, &workspace.v,
                        &workspace.squared_norm})
      values->resize(n);
    for(std::size_t k = 0; k < n; ++k) {
      const Vector position = row(x, workspace.nodes[k]);
      workspace.x[k] = position.x();
      workspace.y[k] = position.y();
      workspace.z[k] = position.z();
    }
  }

  void measure_circle(const Vector& center, std::size_t c, double cap, Workspace& workspace)
  {
    invert(center, m_circles[c], cap, workspace);
    const std::size_t n = number_of_directions();
    workspace.support.assign(n, 1.); // the cap
    workspace.supporting.assign(n, -1);
    for(std::size_t k = 0; k < workspace.nodes.size(); ++k)
      // Only images outside the unit circle lie beyond the cap in some direction. The node itself
      // and coincident ones have no image: their norm is not a number.
      if(workspace.squared_norm[k] > 1) add_image(k, workspace);
    for(std::size_t l = 0; l < n; ++l) {
      if(!is_open(c, l)) continue;
      const std::int64_t k = workspace.supporting[l];
      m_radius[c * n + l] = cap / workspace.support[l];
      m_touching[c * n + l] = k < 0 ? open_sphere : workspace.nodes[static_cast<std::size_t>(k)];
    }
  }

  static void invert(const Vector& center,
                     const Node_circle& circle,
                     double cap,
                     Workspace& workspace)
  {
    const double *x = workspace.x.data(), *y = workspace.y.data(), *z = workspace.z.data();
    double *u = workspace.u.data(), *v = workspace.v.data();
    double* squared_norm = workspace.squared_norm.data();
    const Vector a = circle.u, b = circle.v;
    for(std::size_t k = 0, n = workspace.nodes.size(); k < n; ++k) {
      const double dx = x[k] - center.x(), dy = y[k] - center.y(), dz = z[k] - center.z();
      const double scale = 2 * cap / (dx * dx + dy * dy + dz * dz);
      u[k] = scale * (dx * a.x() + dy * a.y() + dz * a.z());
      v[k] = scale * (dx * b.x() + dy * b.y() + dz * b.z());
      squared_norm[k] = u[k] * u[k] + v[k] * v[k];
    }
  }

  void add_image(std::size_t k, Workspace& workspace) const
  {
    const double u = workspace.u[k], v = workspace.v[k];
    const double *cosine = m_cosine.data(), *sine = m_sine.data();
    double* support = workspace.support.data();
    std::int64_t* supporting = workspace.supporting.data();
    const auto node = static_cast<std::int64_t>(k);
    for(std::size_t l = 0, n = number_of_directions(); l < n; ++l) {
      const double value = cosine[l] * u + sine[l] * v;
      supporting[l] = value > support[l] ? node : supporting[l];
      support[l] = value > support[l] ? value : support[l];
    }
  }

  std::vector<Node_circle> m_circles;
  std::vector<double> m_cosine, m_sine;
  std::vector<double> m_radius;  // circle after circle
  std::vector<Index> m_touching; // likewise
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEDIAL_SPHERES_H
