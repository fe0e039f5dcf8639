// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Diagrams of polygons with integer coordinates, against an independent computation with integers:
// along many directions such polygons are degenerate in every way.

#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/diagram_of_curve.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/is_planar_diagram.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <set>
#include <vector>

namespace test_polygon_projection {

namespace VFC = CGAL::Volume_filling_curves;
using namespace VFC::internal;
using VFC::Planar_diagram;
using Integer = std::int64_t;
using Point = std::array<Integer, 3>;
using Polygon = std::vector<Point>;

Point operator-(const Point& p, const Point& q)
{
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

Integer determinant(const Point& u, const Point& v, const Point& w)
{
  return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
         u[2] * (v[0] * w[1] - v[1] * w[0]);
}

Integer dot(const Point& u, const Point& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

// A fraction with a positive denominator
struct Fraction
{
  Integer numerator, denominator;

  friend bool operator<(const Fraction& a, const Fraction& b)
  {
    return a.numerator * b.denominator < b.numerator * a.denominator;
  }
};

Fraction fraction(Integer numerator, Integer denominator)
{
  return denominator < 0 ? Fraction{-numerator, -denominator} : Fraction{numerator, denominator};
}

// The crossings as a set of quadruples of arcs, by the definition: all pairs of edges, parametrized
// by Cramer's rule.
class Brute_force
{
public:
  Brute_force(const std::vector<Polygon>& polygons, const Point& direction) : m_direction(direction)
  {
    for(const Polygon& polygon : polygons)
      for(std::size_t i = 0; i < polygon.size(); ++i)
        m_edges.push_back({polygon[i], polygon[(i + 1) % polygon.size()], &polygon, i});
  }

  std::optional<std::multiset<std::array<std::size_t, 4>>> operator()()
  {
    for(std::size_t e = 0; e < m_edges.size(); ++e)
      for(std::size_t f = 0; f < e; ++f)
        if(!meet(m_edges[e], m_edges[f])) return std::nullopt;
    return numbered();
  }

private:
  struct Pass
  {
    Fraction place;
    std::size_t crossing;
    bool is_over;

    friend bool operator<(const Pass& a, const Pass& b) { return a.place < b.place; }
  };
  struct Edge
  {
    Point source, target;
    const Polygon* polygon;
    std::size_t index;
    std::vector<Pass> passes{};
  };

  bool are_neighbors(const Edge& e, const Edge& f) const
  {
    const std::size_t n = e.polygon->size();
    return e.polygon == f.polygon && ((e.index + 1) % n == f.index || (f.index + 1) % n == e.index);
  }

  // e(s) = f(t) in the image: source + s u - t v = w modulo the direction
  bool meet(Edge& e, Edge& f)
  {
    const Point u = e.target - e.source, v = f.target - f.source, w = f.source - e.source;
    const Integer area = determinant(u, v, m_direction);
    if(area == 0) return are_parallel_apart(e, f);
    if(are_neighbors(e, f)) return true;
    const Fraction s = fraction(determinant(w, v, m_direction), area);
    const Fraction t = fraction(determinant(w, u, m_direction), area);
    const auto is_out = [](const Fraction& x) {
      return x.numerator < 0 || x.numerator > x.denominator;
    };
    const auto is_end = [](const Fraction& x) {
      return x.numerator == 0 || x.numerator == x.denominator;
    };
    if(is_out(s) || is_out(t)) return true;
    if(is_end(s) || is_end(t)) return false;
    // how far e is above f, times |d|^2 and the area: e(s) - f(t) is a multiple of the direction
    Integer gap = 0;
    for(std::size_t k = 0; k < 3; ++k)
      gap += m_direction[k] * (-w[k] * s.denominator + s.numerator * u[k] - t.numerator * v[k]);
    if(gap == 0) return false;
    e.passes.push_back({s, m_signs.size(), gap > 0});
    f.passes.push_back({t, m_signs.size(), gap < 0});
    m_signs.push_back((area > 0) == (gap > 0));
    return true;
  }

  // parallel images: on different lines, or without a common point but that of neighbors
  bool are_parallel_apart(const Edge& e, const Edge& f) const
  {
    const Point u = e.target - e.source, v = f.target - f.source;
    const auto image = [&](const Point& p) { // in a plane across the direction, times |d|^2
      const Integer height = dot(p, m_direction), norm = dot(m_direction, m_direction);
      return Point{norm * p[0] - height * m_direction[0], norm * p[1] - height * m_direction[1],
                   norm * p[2] - height * m_direction[2]};
    };
    const Point axis = image(u);
    if(dot(axis, axis) == 0 || dot(image(v), image(v)) == 0) return false;
    if(determinant(u, f.source - e.source, m_direction) != 0) return true;
    const auto along = [&](const Point& p) { return dot(axis, image(p)); };
    const auto [a, b] = std::minmax({along(e.source), along(e.target)});
    const auto [c, d] = std::minmax({along(f.source), along(f.target)});
    return are_neighbors(e, f) ? b <= c || d <= a : b < c || d < a;
  }

  std::optional<std::multiset<std::array<std::size_t, 4>>> numbered()
  {
    std::vector<std::array<std::size_t, 4>> arcs(m_signs.size());
    std::vector<std::size_t> order; // of the crossings, as they are met
    std::vector<Pass> along;        // the component
    std::size_t arc = 0;
    for(std::size_t e = 0; e < m_edges.size(); ++e) {
      auto& passes = m_edges[e].passes;
      std::sort(passes.begin(), passes.end());
      for(std::size_t k = 1; k < passes.size(); ++k)
        if(!(passes[k - 1] < passes[k])) return std::nullopt;
      along.insert(along.end(), passes.begin(), passes.end());
      if(e + 1 < m_edges.size() && m_edges[e + 1].polygon == m_edges[e].polygon) continue;
      for(const Pass& pass : along) order.push_back(pass.crossing);
      begin_as_diagrams_do(along, order);
      for(std::size_t k = 0; k < along.size(); ++k) {
        const std::size_t in = along[k].is_over ? (m_signs[along[k].crossing] ? 3 : 1) : 0;
        arcs[along[k].crossing][in] = arc + k;
        arcs[along[k].crossing][(in + 2) % 4] = arc + (k + 1) % along.size();
      }
      arc += along.size();
      along.clear();
    }
    return {{arcs.begin(), arcs.end()}};
  }

  // see Diagram_strands: the start of a component of two arcs above all others
  static void begin_as_diagrams_do(std::vector<Pass>& along, const std::vector<std::size_t>& order)
  {
    if(along.size() != 2 || !along[0].is_over || !along[1].is_over) return;
    const auto rank = [&](const Pass& pass) {
      return std::find(order.begin(), order.end(), pass.crossing);
    };
    if(rank(along[0]) > rank(along[1])) std::swap(along[0], along[1]);
  }

  std::vector<Edge> m_edges;
  std::vector<bool> m_signs;
  const Point m_direction;
};

Closed_polygons in_doubles(const std::vector<Polygon>& polygons)
{
  Closed_polygons result;
  for(const Polygon& polygon : polygons) {
    for(const Point& p : polygon)
      result.points.emplace_back(double(p[0]), double(p[1]), double(p[2]));
    result.close();
  }
  return result;
}

// A polygon of unit steps that does not meet itself: detours around edges of a square, where there
// is room.
Polygon lattice_polygon(std::mt19937& engine, std::size_t detours)
{
  Polygon polygon{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  std::set<Point> used(polygon.begin(), polygon.end());
  for(std::size_t k = 0; k < detours; ++k) {
    const std::size_t i = engine() % polygon.size();
    const Point p = polygon[i], q = polygon[(i + 1) % polygon.size()];
    Point step{};
    step[engine() % 3] = engine() % 2 == 0 ? 1 : -1;
    const Point back{-step[0], -step[1], -step[2]}, a = p - back, b = q - back;
    if(dot(step, q - p) != 0 || used.count(a) > 0 || used.count(b) > 0) continue;
    used.insert(a);
    used.insert(b);
    polygon.insert(polygon.begin() + std::ptrdiff_t(i) + 1, {a, b});
  }
  return polygon;
}

Polygon integer_polygon(std::mt19937& engine, std::size_t n)
{
  Polygon polygon(n);
  for(Point& p : polygon)
    for(Integer& x : p) x = static_cast<Integer>(engine() % 7);
  return polygon;
}

Point small_direction(std::mt19937& engine, Integer size)
{
  Point d{};
  while(dot(d, d) == 0)
    for(Integer& x : d) x = static_cast<Integer>(engine()) % (2 * size + 1) - size;
  return d;
}

struct Counts
{
  std::size_t generic = 0, refused = 0, crossings = 0;
};

void expect_agreement(const std::vector<Polygon>& polygons, const Point& d, Counts& counts)
{
  const Closed_polygons points = in_doubles(polygons);
  const auto diagram = Polygon_projection(points, {int(d[0]), int(d[1]), int(d[2])})();
  const auto expected = Brute_force(polygons, d)();
  ASSERT_EQ(diagram.has_value(), expected.has_value());
  ++(diagram ? counts.generic : counts.refused);
  if(!diagram) return;
  ASSERT_TRUE(is_planar_diagram(*diagram));
  std::multiset<std::array<std::size_t, 4>> crossings;
  for(const auto& x : diagram->crossings) crossings.insert({x[0], x[1], x[2], x[3]});
  ASSERT_EQ(crossings, *expected);
  counts.crossings += crossings.size();
}

TEST(Polygon_projection, Agrees_with_brute_force_on_lattice_polygons)
{
  std::mt19937 engine(1);
  Counts counts;
  for(int k = 0; k < 3000; ++k) {
    const Polygon polygon = lattice_polygon(engine, 40);
    for(const Integer size : {1, 3, 20}) {
      expect_agreement({polygon}, small_direction(engine, size), counts);
      ASSERT_FALSE(HasFatalFailure()) << k;
    }
  }
  EXPECT_GT(counts.generic, 1500u);
  EXPECT_GT(counts.refused, 1500u);
  EXPECT_GT(counts.crossings, 5000u);
}

// Several polygons, which may also meet themselves and each other.
TEST(Polygon_projection, Agrees_with_brute_force_on_any_integer_polygons)
{
  std::mt19937 engine(2);
  Counts counts;
  for(int k = 0; k < 1000; ++k) {
    std::vector<Polygon> polygons;
    for(std::size_t c = 0; c <= engine() % 2; ++c)
      polygons.push_back(integer_polygon(engine, 3 + engine() % 5));
    for(const Integer size : {2, 50}) {
      expect_agreement(polygons, small_direction(engine, size), counts);
      ASSERT_FALSE(HasFatalFailure()) << k;
    }
  }
  EXPECT_GT(counts.generic, 100u);
  EXPECT_GT(counts.refused, 100u);
}

// Rational numbers decide here: the crossings on an edge are 2^-40 apart.
TEST(Polygon_projection, Close_crossings_are_in_order)
{
  const auto with_gap = [](double gap) {
    Closed_polygons polygons;
    const auto add_triangle = [&](Vector p, Vector q, Vector r) {
      polygons.points.insert(polygons.points.end(), {p, q, r});
      polygons.close();
    };
    add_triangle({-8, 0, 0}, {8, 0, 0}, {0, -8, 0});
    add_triangle({-1, -1, 1}, {1, 1, 1}, {-1, 8, 1});
    add_triangle({1 + gap, -1, 2}, {-1 + gap, 1, 2}, {-7, 6, 2});
    return Polygon_projection(polygons, {0, 0, 1})();
  };
  EXPECT_FALSE(with_gap(0));
  const auto left = with_gap(-0x1p-50), right = with_gap(0x1p-50);
  ASSERT_TRUE(left && right);
  EXPECT_NE(left->crossings, right->crossings);
  EXPECT_TRUE(is_planar_diagram(*left));
  EXPECT_TRUE(is_planar_diagram(*right));
}

TEST(Polygon_projection, Polygons_that_meet_have_no_diagram)
{
  const Closed_polygons polygons =
      in_doubles({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{1, 1, -2}, {2, 0, 0}, {1, 1, 2}}});
  EXPECT_THROW(best_diagram(polygons, 3), std::invalid_argument);
}

TEST(Polygon_projection, Torus_knots_have_their_signs)
{
  for(const int q : {3, -3}) {
    const auto curve = VFC::make_torus_knot(2, q, 100);
    const Planar_diagram diagram = best_diagram(closed_polygons(curve), 20);
    EXPECT_EQ(diagram.crossings.size(), 3u);
    EXPECT_EQ(VFC::internal::writhe(diagram), q > 0 ? 3 : -3);
  }
}

TEST(Polygon_projection, Diagrams_do_not_depend_on_the_scale)
{
  const auto curve = VFC::make_random_polygon(200, 1);
  Closed_polygons polygons = closed_polygons(curve);
  const Planar_diagram diagram = best_diagram(polygons, 3);
  for(const double scale : {0x1p-300, 0x1p300}) {
    Closed_polygons scaled = polygons;
    for(Vector& p : scaled.points) p = p * scale;
    EXPECT_EQ(best_diagram(scaled, 3).crossings, diagram.crossings);
  }
}

} // namespace test_polygon_projection
