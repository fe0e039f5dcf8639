// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The exact predicates on random points, which the floating-point filters decide, and on points of
// a plane, where they give up and exact arithmetic decides.

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Exact_predicates.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>

#include <benchmark/benchmark.h>

#include <cstddef>
#include <vector>

namespace {

namespace vfc = CGAL::Volume_filling_curves;
using Traits = vfc::Curve_flow_traits_3<>;
using Point_3 = Traits::Point_3;

constexpr std::size_t number_of_points = 1000;

enum class Position
{
  IN_SPACE,
  ON_A_LATTICE, // coplanar and collinear now and then
  IN_A_PLANE
};

std::vector<Point_3> random_points(Position position)
{
  constexpr std::size_t lattice_size = 4;
  vfc::internal::Random_source random(1);
  const auto coordinate = [&] {
    return position == Position::ON_A_LATTICE ? static_cast<double>(random.index(lattice_size))
                                              : random.real();
  };
  std::vector<Point_3> points;
  while(points.size() < number_of_points) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    points.emplace_back(x, y, position == Position::IN_A_PLANE ? 0 : z);
  }
  return points;
}

void segment_triangle(benchmark::State& state)
{
  const vfc::internal::Exact_predicates<Traits> predicates{Traits()};
  const std::vector<Point_3> p = random_points(static_cast<Position>(state.range(0)));
  std::size_t k = 0, number_of_hits = 0;
  for(auto _ : state) {
    number_of_hits +=
        predicates.does_segment_meet_triangle(p[k], p[k + 1], p[k + 2], p[k + 3], p[k + 4]);
    k = (k + 1) % (number_of_points - 4);
  }
  state.counters["hits"] =
      benchmark::Counter(static_cast<double>(number_of_hits), benchmark::Counter::kAvgIterations);
}

void segment_triangle_at_corner(benchmark::State& state)
{
  const vfc::internal::Exact_predicates<Traits> predicates{Traits()};
  const std::vector<Point_3> p = random_points(static_cast<Position>(state.range(0)));
  std::size_t k = 0, number_of_hits = 0;
  for(auto _ : state) {
    number_of_hits +=
        predicates.does_segment_meet_triangle_beyond_corner(p[k], p[k + 1], p[k + 2], p[k + 3]);
    k = (k + 1) % (number_of_points - 3);
  }
  state.counters["hits"] =
      benchmark::Counter(static_cast<double>(number_of_hits), benchmark::Counter::kAvgIterations);
}

void positions(benchmark::internal::Benchmark* benchmark)
{
  for(Position position : {Position::IN_SPACE, Position::ON_A_LATTICE, Position::IN_A_PLANE})
    benchmark->Arg(static_cast<int>(position));
}
BENCHMARK(segment_triangle)->Apply(positions);
BENCHMARK(segment_triangle_at_corner)->Apply(positions);

} // namespace
