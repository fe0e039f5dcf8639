// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_SHAPE_PROJECTION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_SHAPE_PROJECTION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/bending/Shape_goal.h>
#include <CGAL/Volume_filling_curves/internal/bending/Strand_pairs.h>
#include <CGAL/Volume_filling_curves/internal/bending/Strand_paths.h>
#include <CGAL/Volume_filling_curves/internal/bending/Wall_planes.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/elementary_functions.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_passage.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Projection of the nodes of a curve towards the limits of its shape, constraint by constraint
// (position based dynamics; Mueller et al. 2007): strands move apart, corners open, and nodes leave
// the walls. Corners of nodes 4, 2 and 1 apart are opened in turn, since corners of neighbors alone
// take hundreds of sweeps for a bend. Each sweep visits the constraints in the order of the curve.
// Displacements are linear combinations of differences of positions and of the walls' normals,
// hence do not depend on the frame. Linear time.
class Shape_projection
{
  using Path = Strand_paths::Path;
  using Index = Strand_paths::Index;

public:
  // The limits and the pairs must outlive the projection.
  template <typename Network>
  Shape_projection(const Network& curve,
                   const Shape_limits& limits,
                   const Strand_pairs& pairs,
                   const Wall_planes& walls)
      : m_paths(curve), m_limits(limits), m_pairs(pairs), m_walls(walls)
  {
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
      m_mobility.push_back(curve.is_free(v) ? 1 : 0);
    for(const auto& p : curve.points()) m_start.push_back(to_vector(p));
  }

  // Holds the other nodes where they are.
  void move_only(const std::vector<bool>& moving)
  {
    for(std::size_t v = 0; v < m_mobility.size(); ++v)
      if(!moving[v]) m_mobility[v] = 0;
  }

  // Sweeps over nodes at x. A tense curve keeps its length; otherwise its edges are evened.
  void operator()(std::vector<Vector>& x, int sweeps, bool is_tense) const
  {
    std::vector<std::vector<double>> lengths;
    for(const Path& path : paths())
      if(is_tense) lengths.push_back(lengths_to_keep(path));
    std::vector<Contact> contacts;
    for(int k = 0; k < sweeps; ++k) {
      check_run();
      if(k % sweeps_per_search == 0) contacts = find_contacts(x);
      for(std::size_t p = 0; p < paths().size(); ++p)
        is_tense ? keep_lengths(x, paths()[p], lengths[p]) : even(x, paths()[p]);
      for(Contact& contact : contacts) push_apart(x, contact);
      m_walls.push_inside(x, m_mobility);
      for(const Path& path : paths()) {
        if(is_too_short(x, path)) {
          widen(x, path);
        } else {
          open_corners<4>(x, path);
          open_corners<2>(x, path);
          open_corners<1>(x, path);
        }
      }
    }
  }

private:
  // Projections converge from outside, hence aim slightly beyond the limits, by this factor.
  // With 1.02 domains are filled to 0.7 % less (2026-11-26).
  static constexpr double margin = 1.01;

  // Of the pairs that may come close, sweeps visit those that are: with all of them a cube of side
  // 20 r takes 1.2 times as long (2026-11-25).
  static constexpr int sweeps_per_search = 8;
  static constexpr double slack_of_contacts = 0.03; // in distances of strands

  struct Contact
  {
    std::array<Index, 4> ends; // of one edge, and of the other
    double distance;           // to be kept
    Vector side;               // of the one edge, seen from the other
  };

  std::vector<Contact> find_contacts(const std::vector<Vector>& x) const
  {
    std::vector<Contact> contacts;
    for(const auto& [e, f] : m_pairs.pairs()) {
      const double distance = margin * m_pairs.distance(e, f);
      const auto [i, j] = m_pairs.ends(e);
      const auto [k, l] = m_pairs.ends(f);
      if(are_held({i, j, k, l})) continue;
      if(!Strand_pairs::are_middles_apart((1 + slack_of_contacts) * distance, x[i], x[j], x[k],
                                          x[l]))
        contacts.push_back({{i, j, k, l}, distance, side({i, j, k, l}, x)});
    }
    return contacts;
  }

  // Edges that have passed through each other since the start are on the wrong side: pushed apart
  // from there, strands would press against each other for ever, since the guard stops them. Of 30
  // fillings of ten domains, two ended in such hooks (2026-11-26).
  Vector side(const std::array<Index, 4>& ends, const std::vector<Vector>& x) const
  {
    Segment_pair from, to;
    for(std::size_t k = 0; k < ends.size(); ++k) {
      from[k] = m_start[ends[k]];
      to[k] = x[ends[k]];
    }
    const Vector chord = nearest_chord(to);
    return do_pass(from, to) ? -1 * chord : chord;
  }

  const std::vector<Path>& paths() const { return m_paths.paths(); }

  // the i-th node of all paths, also beyond the end of a closed one
  std::size_t node(const Path& path, std::size_t i) const
  {
    return m_paths.nodes()[i < path.end ? i : i - path.size()];
  }

  bool are_held(std::initializer_list<std::size_t> nodes) const
  {
    for(const std::size_t v : nodes)
      if(m_mobility[v] > 0) return false;
    return true;
  }

  void move(std::vector<Vector>& x, std::size_t v, const Vector& shift) const
  {
    x[v] += m_mobility[v] * shift;
  }

  // Lengths of the edges to be kept: their sum is that at the start, except next to held nodes.
  // Arcs get even edges: short ones behind the necks of ports would stay short, and six of 56
  // fillings between ports would not converge, instead of one (2026-11-27).
  std::vector<double> lengths_to_keep(const Path& path) const
  {
    std::vector<double> lengths;
    for(std::size_t i = path.begin; i < path.begin + path.number_of_edges(); ++i)
      lengths.push_back((m_start[node(path, i + 1)] - m_start[node(path, i)]).norm());
    return path.is_closed ? averaged(lengths) : evened(path, lengths);
  }

  // Averages over seven successive edges of a closed path. With even edges instead, eight domains
  // are filled to 0.5 % less in 1.1 times the time: bends within their limits give way.
  static std::vector<double> averaged(const std::vector<double>& lengths)
  {
    const std::size_t n = lengths.size(), reach = (std::min)(n, std::size_t(3));
    std::vector<double> averages(n, 0);
    for(std::size_t i = 0; i < n; ++i)
      for(std::size_t k = i + n - reach; k <= i + n + reach; ++k)
        averages[i] += lengths[k % n] / static_cast<double>(2 * reach + 1);
    return averages;
  }

  // Edges are as long as the thickness asks for, where that varies. With the same length for all,
  // the curve contracted: in a cube whose thickness grows from 0.15 to 0.6 to half of its length.
  // The mean is that of edges which are not held: those in the necks of ports stay as they are, and
  // being shorter they would make all others shrink in each sweep.
  std::vector<double> evened(const Path& path, const std::vector<double>& lengths) const
  {
    const auto limit = [&](std::size_t v) {
      return m_limits.bend_radius[v] + m_limits.strand_distance[v];
    };
    std::vector<double> limits;
    double sum = 0, sum_of_limits = 0;
    for(std::size_t i = 0; i < lengths.size(); ++i) {
      const std::size_t v = node(path, path.begin + i), w = node(path, path.begin + i + 1);
      limits.push_back((std::max)(limit(v), limit(w))); // a ray has none
      if(are_held({v, w})) continue;
      sum += lengths[i];
      sum_of_limits += limits.back();
    }
    for(double& length : limits) length *= sum_of_limits > 0 ? sum / sum_of_limits : 0;
    return limits;
  }

  void keep_lengths(std::vector<Vector>& x,
                    const Path& path,
                    const std::vector<double>& lengths) const
  {
    for(std::size_t i = 0; i < lengths.size(); ++i) {
      const std::size_t v = node(path, path.begin + i), w = node(path, path.begin + i + 1);
      if(are_held({v, w})) continue;
      const Vector edge = x[w] - x[v];
      const double now = edge.norm();
      if(!(now > 0)) continue;
      const Vector half = (now - lengths[i]) / (2 * now) * edge;
      move(x, v, half);
      move(x, w, -half);
    }
  }

  // Slides nodes towards the longer one of their edges, since corners between uneven edges bend
  // sharply (Rawdon's MinRad). Folds have no direction to slide in.
  void even(std::vector<Vector>& x, const Path& path) const
  {
    constexpr double rate = 0.2, fold = 0.5;
    const std::size_t ends = path.is_closed ? 0 : 1;
    for(std::size_t i = path.begin + ends; i < path.end - ends; ++i) {
      const std::size_t v = node(path, i), w = node(path, i + 1);
      const std::size_t u = node(path, i > path.begin ? i - 1 : path.end - 1);
      const Vector in = x[v] - x[u], out = x[w] - x[v];
      const double length_in = in.norm(), length_out = out.norm();
      if(!(length_in > 0 && length_out > 0)) continue;
      const Vector tangent = in / length_in + out / length_out;
      const double norm = tangent.norm();
      if(norm > fold) move(x, v, rate * (length_out - length_in) / norm * tangent);
    }
  }

  // Each end moves in proportion to its weight in the nearest point. Edges that have passed through
  // each other move back.
  void push_apart(std::vector<Vector>& x, Contact& contact) const
  {
    const auto [i, j, k, l] = contact.ends;
    const double distance = contact.distance;
    const Vector a = x[i], b = x[j], c = x[k], d = x[l];
    if(Strand_pairs::are_middles_apart(distance, a, b, c, d)) return;
    const auto [s, t] = nearest_points(a, b, c, d);
    const Vector chord = (a + s * (b - a)) - (c + t * (d - c));
    const double now = chord.norm();
    if(!(now < distance && now > 0)) return;
    const double sign = chord.dot(contact.side) < 0 ? -1 : 1;
    contact.side = sign * chord;
    const double weight = (1 - s) * (1 - s) + s * s + (1 - t) * (1 - t) + t * t;
    const Vector push = (distance - sign * now) / (now * weight) * contact.side;
    move(x, i, (1 - s) * push);
    move(x, j, s * push);
    move(x, k, -(1 - t) * push);
    move(x, l, -t * push);
  }

  // Opens the corners of nodes that are `apart` nodes apart.
  template <std::size_t apart>
  void open_corners(std::vector<Vector>& x, const Path& path) const
  {
    if(path.size() <= 2 * apart) return;
    const Index* const nodes = m_paths.nodes().data();
    for(std::size_t i = path.begin; i + 2 * apart < path.end; ++i) open_corner<apart>(x, nodes + i);
    if(!path.is_closed) return;
    Index around[2 * apart + 1];
    for(std::size_t i = path.end - 2 * apart; i < path.end; ++i) {
      for(std::size_t k = 0; k <= 2 * apart; ++k) around[k] = static_cast<Index>(node(path, i + k));
      open_corner<apart>(x, around);
    }
  }

  // The arc that is tangent to both edges of a corner and touches the shorter one in its middle has
  // the limit for its radius if the sine of half of the turn is q / sqrt(1 + q^2), where q is half
  // of the shorter edge over the radius; the chords of a circle have the sine q. The node in the
  // middle moves half of the excess relative to the outer ones, nodes in between move a share of
  // that, and the mean of all stays: otherwise even bends would move to their inner side, and rings
  // would shrink to points.
  template <std::size_t apart>
  void open_corner(std::vector<Vector>& x, const Index* nodes) const
  {
    const std::size_t v = nodes[apart];
    if(are_held({nodes[0], v, nodes[2 * apart]})) return;
    const Vector in = x[v] - x[nodes[0]], out = x[nodes[2 * apart]] - x[v];
    const double in2 = in.squaredNorm(), out2 = out.squaredNorm(), edge2 = (std::min)(in2, out2);
    const double radius = margin * m_limits.bend_radius[v];
    const double diameter2 = 4 * radius * radius;                      // q2 = edge2 / diameter2
    const double divisor = apart == 1 ? diameter2 + edge2 : diameter2; // sine2 = edge2 / divisor
    const double product = std::sqrt(in2 * out2);
    if(!(edge2 > 0) || divisor * in.dot(out) >= (divisor - 2 * edge2) * product) return;
    const double edge = std::sqrt(edge2);
    const Vector bend = edge * (out / std::sqrt(out2) - in / std::sqrt(in2));
    const double size = bend.norm(), most = 2 * edge2 / std::sqrt(divisor);
    if(!(size > most)) return;
    if(apart == 1 && m_mobility[v] == 0)
      return turn_neighbors(x, nodes, (size - most) / (size * edge) * bend);
    const Vector sixth = (size - most) / (6 * size) * bend;
    constexpr double n = apart, mean = (n - 1) / (2 * n + 1);
    move(x, v, (2 - mean) * sixth);
    for(std::size_t k = 1; k <= apart; ++k) {
      const Vector shift = (2 - mean - 3 * static_cast<double>(k) / n) * sixth;
      move(x, nodes[apart - k], shift);
      move(x, nodes[apart + k], shift);
    }
  }

  // The neighbors of a pinned node turn around it until its bend, of edges of length 1, has lost
  // the excess. As outer nodes of the corner they would move a sixth of that: the corner at the end
  // of a neck kept a radius of 0.2 r.
  void turn_neighbors(std::vector<Vector>& x, const Index* nodes, const Vector& excess) const
  {
    const std::size_t u = nodes[0], v = nodes[1], w = nodes[2];
    const double number = m_mobility[u] + m_mobility[w];
    if(number == 0) return;
    const double in = (x[v] - x[u]).norm(), out = (x[w] - x[v]).norm();
    move(x, u, -in / number * excess);
    move(x, w, -out / number * excess);
  }

  // Whether a closed curve is shorter than a ring with the limit for its radius. Its stiffness
  // would shrink it to a point; therefore it is widened, and its corners are not opened. Most
  // curves are far longer, which some of their edges already show.
  bool is_too_short(const std::vector<Vector>& x, const Path& path) const
  {
    if(!path.is_closed) return false;
    const double n = static_cast<double>(path.size());
    const auto [cosine, sine] = cos_sin(0.5 / n);
    const double radius = margin * m_limits.bend_radius[node(path, path.begin)];
    const double ring = 2 * n * radius * sine / cosine; // of n edges
    double length = 0;
    for(std::size_t i = path.begin; i < path.end && length < ring; ++i)
      length += (x[node(path, i + 1)] - x[node(path, i)]).norm();
    return length < ring;
  }

  // Moves the nodes away from their center.
  void widen(std::vector<Vector>& x, const Path& path) const
  {
    constexpr double rate = 0.02;
    Vector center;
    for(std::size_t i = path.begin; i < path.end; ++i)
      center += x[node(path, i)] / static_cast<double>(path.size());
    for(std::size_t i = path.begin; i < path.end; ++i) {
      const std::size_t v = node(path, i);
      move(x, v, rate * (x[v] - center));
    }
  }

  const Strand_paths m_paths;
  const Shape_limits& m_limits;
  const Strand_pairs& m_pairs;
  const Wall_planes& m_walls;
  std::vector<Vector> m_start;    // positions of the nodes
  std::vector<double> m_mobility; // of each node, 0 if it is held
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_SHAPE_PROJECTION_H
