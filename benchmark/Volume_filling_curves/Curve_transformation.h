// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_BENCHMARK_CURVE_TRANSFORMATION_H
#define VFC_BENCHMARK_CURVE_TRANSFORMATION_H

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "Json_line.h"

namespace vfc_benchmark {

using Curve = CGAL::Volume_filling_curves::Curve_network_3<>;

// Changes of an input that must not change what becomes of it: noise first, then a mirror image, a
// rotation, a scaling and a translation. Seeds are 0 for none.
struct Curve_transformation
{
  std::uint64_t jitter_seed = 0, rotation_seed = 0;
  bool is_mirrored = false;
  double scale = 1, translation = 0; // the latter in units of the box diagonal

  Curve operator()(const Curve& curve) const
  {
    auto x = CGAL::Volume_filling_curves::internal::coordinates(curve);
    if(jitter_seed > 0) add_noise(x);
    if(is_mirrored) x.col(0) *= -1;
    if(rotation_seed > 0) x = (x * rotation().transpose()).eval();
    x *= scale;
    const Eigen::RowVector3d way = Eigen::RowVector3d(3, -2, 1).normalized();
    if(translation != 0) x.rowwise() += (translation * diagonal(x) * way).eval();
    return with_coordinates(curve, x);
  }

  Json_line description() const
  {
    Json_line line;
    line.add("jitter", jitter_seed)
        .add("rotate", rotation_seed)
        .add("mirror", is_mirrored)
        .add("scale", scale)
        .add("translate", translation);
    return line;
  }

private:
  using Random_source = CGAL::Volume_filling_curves::internal::Random_source;
  using Vector_field = CGAL::Volume_filling_curves::internal::Vector_field;

  static constexpr double noise = 1e-5; // of the box diagonal

  static double diagonal(const Vector_field& x)
  {
    return CGAL::Volume_filling_curves::internal::sides(x).norm();
  }

  void add_noise(Vector_field& x) const
  {
    Random_source random(jitter_seed);
    const double amplitude = noise * diagonal(x);
    for(Eigen::Index v = 0; v < x.rows(); ++v)
      for(Eigen::Index k = 0; k < 3; ++k) x(v, k) += amplitude * (2 * random.real() - 1);
  }

  Eigen::Matrix3d rotation() const
  {
    Random_source random(rotation_seed);
    const auto direction = random.direction();
    const Eigen::Vector3d axis(direction.x(), direction.y(), direction.z());
    return Eigen::AngleAxisd(6 * random.real(), axis).toRotationMatrix();
  }

  static Curve with_coordinates(const Curve& curve, const Vector_field& x)
  {
    std::vector<Curve::Point_3> points;
    for(Eigen::Index v = 0; v < x.rows(); ++v) points.emplace_back(x(v, 0), x(v, 1), x(v, 2));
    std::vector<std::array<std::size_t, 2>> edges;
    for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
      edges.push_back({curve.source(e), curve.target(e)});
    Curve result(points, edges);
    for(std::size_t v = 0; v < result.number_of_nodes(); ++v)
      result.set_pinned(v, curve.is_pinned(result.origin(v)));
    return result;
  }
};

} // namespace vfc_benchmark

#endif // VFC_BENCHMARK_CURVE_TRANSFORMATION_H
