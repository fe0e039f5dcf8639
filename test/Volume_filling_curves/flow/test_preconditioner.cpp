// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/flow_test_support.h"

#include <CGAL/Volume_filling_curves/internal/flow/Direction_solver.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

// The preconditioner against a dense matrix filled pair by pair, and its solvers.
namespace test_preconditioner {

using namespace flow_test;
using CGAL::Volume_filling_curves::Preconditioner;
using internal::Medial_sphere_search;
using internal::Medial_spheres;
using internal::Sparse_matrix;
using internal::Touching_nodes;
using Pairs = std::map<std::pair<std::size_t, std::size_t>, double>;

constexpr double thickness = 0.4, lambda = 0.3 / (thickness * thickness), beta = 0.01;
constexpr double alpha = 3.36 * 3.36 / (thickness * thickness);
constexpr Preconditioner kinds[] = {Preconditioner::MEDIAL, Preconditioner::H1, Preconditioner::L2,
                                    Preconditioner::QUASI_NEWTON, Preconditioner::CONTACT};

Sparse_matrix matrix_of(Preconditioner kind, const Network& curve, double scale = 1)
{
  const Vector_field x = internal::coordinates(curve);
  CGAL::Volume_filling_curves::Curve_flow_parameters parameters;
  parameters.preconditioner = kind;
  const double r = thickness * scale;
  return internal::preconditioner(parameters, curve, x, internal::node_weights(curve, x),
                                  std::vector<double>(curve.number_of_nodes(), r),
                                  spheres_of(curve, 16, 0.9, r));
}

Eigen::MatrixXd dense(const Sparse_matrix& matrix)
{
  return Eigen::MatrixXd(matrix);
}

Pairs brute_force_pairs(const Medial_spheres& spheres)
{
  Pairs pairs;
  for(std::size_t c = 0; c < spheres.circles().size(); ++c)
    for(std::size_t l = 0; l < spheres.number_of_directions(); ++l) {
      const std::size_t v = spheres.circles()[c].node, w = spheres.touching_node(c, l);
      if(w == Medial_spheres::no_node) continue;
      const auto pair = pairs.emplace(std::minmax(v, w), spheres.radius(c, l)).first;
      pair->second = (std::min)(pair->second, spheres.radius(c, l));
    }
  return pairs;
}

Eigen::MatrixXd brute_force_matrix(Preconditioner kind, const Network& curve)
{
  const auto n = static_cast<Eigen::Index>(curve.number_of_nodes());
  const Vector_field x = internal::coordinates(curve);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  const auto couple = [&](std::size_t v, std::size_t w, double weight) {
    const auto a = static_cast<Eigen::Index>(v), b = static_cast<Eigen::Index>(w);
    matrix(a, a) += weight;
    matrix(b, b) += weight;
    matrix(a, b) -= weight;
    matrix(b, a) -= weight;
  };
  const double mass = kind == Preconditioner::QUASI_NEWTON ? alpha : lambda;
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
    const std::size_t v = curve.source(e), w = curve.target(e);
    const double length = (internal::row(x, v) - internal::row(x, w)).norm();
    if(kind != Preconditioner::L2) couple(v, w, 1 / length);
    for(std::size_t end : {v, w})
      matrix(static_cast<Eigen::Index>(end), static_cast<Eigen::Index>(end)) += mass * length / 2;
  }
  if(kind == Preconditioner::MEDIAL)
    for(const auto& [pair, radius] : brute_force_pairs(spheres_of(curve, 16, 0.9, thickness)))
      couple(pair.first, pair.second, beta / radius);
  for(Eigen::Index v = 0; v < n; ++v)
    if(curve.is_pinned(static_cast<std::size_t>(v))) {
      matrix.row(v).setZero();
      matrix.col(v).setZero();
      matrix(v, v) = 1;
    }
  return matrix;
}

std::vector<Network> some_curves()
{
  Random random(1);
  std::vector<Network> curves = {internal::closed_network({random_polygon(50, random)}),
                                 junctions_and_ends(40, random), path(random_polygon(30, random)),
                                 internal::closed_network({circle(3)}),
                                 path({{0, 0, 0}, {1, 0, 0}})};
  curves[2].pin_ends();
  curves[1].set_pinned(7);
  return curves;
}

TEST(Preconditioner, is_assembled_as_defined)
{
  for(const Network& curve : some_curves())
    for(Preconditioner kind : kinds) {
      const Eigen::MatrixXd expected = brute_force_matrix(kind, curve);
      const Eigen::MatrixXd matrix = dense(matrix_of(kind, curve));
      EXPECT_LT((matrix - expected).norm(), 1e-12 * expected.norm());
    }
}

TEST(Preconditioner, is_positive_definite)
{
  for(const Network& curve : some_curves())
    for(Preconditioner kind : kinds) {
      const Eigen::MatrixXd matrix = dense(matrix_of(kind, curve));
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix, Eigen::EigenvaluesOnly);
      EXPECT_GT(solver.eigenvalues().minCoeff(), 0);
    }
}

// The pairs of nodes, each of which must be there from both sides.
Pairs pairs_of(const Touching_nodes& touching, std::size_t number_of_nodes)
{
  Pairs low_first, high_first;
  for(std::size_t v = 0; v < number_of_nodes; ++v) {
    std::vector<std::size_t> nodes;
    touching.for_each(v, [&](std::size_t w, double radius) {
      nodes.push_back(w);
      Pairs& pairs = v < w ? low_first : high_first;
      pairs.emplace(std::minmax(v, w), radius);
    });
    EXPECT_EQ(std::adjacent_find(nodes.begin(), nodes.end(), std::greater_equal<>()), nodes.end());
    EXPECT_LE(nodes.size(), touching.max_nodes(v));
  }
  EXPECT_EQ(low_first, high_first);
  return low_first;
}

TEST(Touching_nodes, occur_once_with_the_least_radius)
{
  for(const Network& curve : some_curves()) {
    const Medial_spheres spheres = spheres_of(curve, 16, 0.9, thickness);
    const std::size_t n = curve.number_of_nodes();
    EXPECT_EQ(pairs_of(Touching_nodes(CGAL::Sequential_tag(), spheres, n), n),
              brute_force_pairs(spheres));
  }
}

// The pairs and the radii do not depend on the order of the nodes.
TEST(Touching_nodes, do_not_depend_on_the_order_of_the_nodes)
{
  Random random(2);
  const Vector_field x = random_field(80, random);
  std::vector<std::size_t> place(80); // of a node in the other order
  std::iota(place.begin(), place.end(), 0u);
  std::shuffle(place.begin(), place.end(), random);
  Vector_field y(80, 3);
  std::vector<internal::Node_circle> circles, shuffled;
  for(std::size_t v = 0; v < 80; ++v) {
    circles.emplace_back(v, random_point(random).normalized(), 1.);
    y.row(static_cast<Eigen::Index>(place[v])) = x.row(static_cast<Eigen::Index>(v));
    shuffled.push_back(circles.back());
    shuffled.back().node = place[v];
  }
  std::sort(shuffled.begin(), shuffled.end(),
            [](const auto& a, const auto& b) { return a.node < b.node; });
  const CGAL::Sequential_tag tag;
  const std::vector<double> ones(80, 1.);
  const Touching_nodes touching(tag, Medial_sphere_search(tag, x, ones, 0.5)(circles, 16), 80);
  const Pairs pairs = pairs_of(touching, 80);
  const Pairs others = brute_force_pairs(Medial_sphere_search(tag, y, ones, 0.5)(shuffled, 16));
  ASSERT_EQ(pairs.size(), others.size());
  for(const auto& [pair, radius] : pairs) {
    const auto found = others.find(std::minmax(place[pair.first], place[pair.second]));
    ASSERT_NE(found, others.end());
    EXPECT_EQ(radius, found->second);
  }
}

TEST(Direction_solver, factorizes_small_matrices)
{
  Random random(3);
  internal::Direction_solver solver;
  for(const Network& curve : some_curves())
    for(Preconditioner kind : kinds) {
      const Sparse_matrix matrix = matrix_of(kind, curve);
      const Vector_field b = random_field(curve.number_of_nodes(), random);
      const Eigen::MatrixXd expected = dense(matrix).llt().solve(Eigen::MatrixXd(b));
      EXPECT_LT((solver(matrix, b) - expected).norm(), 1e-9 * expected.norm());
    }
}

TEST(Direction_solver, iterates_on_large_matrices_up_to_its_tolerance)
{
  Random random(4);
  internal::Direction_solver solver;
  for(std::size_t n : {201u, 600u}) {
    Network ring = internal::closed_network({random_polygon(n, random)});
    Network graph = junctions_and_ends(n, random);
    ring.set_pinned(17);
    for(const Network* curve : {&ring, &graph})
      for(Preconditioner kind : kinds) {
        const Sparse_matrix matrix = matrix_of(kind, *curve);
        const Vector_field b = random_field(curve->number_of_nodes(), random);
        const Vector_field residual = b - dense(matrix) * solver(matrix, b);
        EXPECT_LT(residual.norm(), 1.01e-4 * b.norm());
      }
  }
}

TEST(Direction_solver, takes_a_zero_right_hand_side)
{
  internal::Direction_solver solver;
  for(std::size_t n : {30u, 300u}) {
    const Network ring = internal::closed_network({circle(n)});
    const Vector_field zero = Vector_field::Zero(static_cast<Eigen::Index>(n), 3);
    EXPECT_EQ(solver(matrix_of(Preconditioner::MEDIAL, ring), zero), zero);
  }
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(Direction_solver, and_preconditioner_are_the_same_for_all_tags)
{
  Random random(6);
  const Network curve = junctions_and_ends(5000, random);
  const Vector_field x = internal::coordinates(curve);
  const Vector_field b = random_field(curve.number_of_nodes(), random);
  const std::vector<double> thicknesses(curve.number_of_nodes(), thickness);
  const auto direction = [&](auto tag) {
    using Tag = decltype(tag);
    return internal::Direction_solver<Tag>()(
        internal::preconditioner<Tag>({}, curve, x, internal::node_weights(curve, x), thicknesses,
                                      spheres_of(curve, 16, 0.9, thickness)),
        b);
  };
  EXPECT_EQ(direction(CGAL::Parallel_tag()), direction(CGAL::Sequential_tag()));
}
#endif

// P has the unit 1 / length, directions that of a length.
TEST(Direction_solver, scales_with_the_curve_by_powers_of_two)
{
  Random random(5);
  for(std::size_t n : {100u, 300u}) {
    const Network ring = internal::closed_network({random_polygon(n, random)});
    const Vector_field b = random_field(n, random);
    for(Preconditioner kind : kinds)
      for(double scale : {std::ldexp(1., -60), 2., std::ldexp(1., 60)}) {
        const Sparse_matrix matrix = matrix_of(kind, transformed(ring, scale), scale);
        const Vector_field expected = internal::Direction_solver()(matrix_of(kind, ring), b);
        EXPECT_EQ(internal::Direction_solver()(matrix, b), Vector_field(scale * expected));
      }
  }
}

} // namespace test_preconditioner
