// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/flow_test_support.h"

#include <CGAL/Volume_filling_curves/internal/flow/Direction_solver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

// The stiffness of contacts is compared with the change of the forces, and with a dense matrix that
// is filled sphere by sphere.
namespace test_contact_stiffness {

using namespace flow_test;
using CGAL::Volume_filling_curves::Preconditioner;
using internal::Contact_stiffness;
using internal::Medial_spheres;
using internal::Sparse_matrix;

constexpr double thickness = 0.4, medial_weight = 11;
constexpr std::size_t number_of_directions = 16;

Contact_stiffness contacts_of(const Network& curve, double r = thickness)
{
  const Vector_field x = internal::coordinates(curve);
  return {curve,
          x,
          internal::node_weights(curve, x),
          std::vector<double>(curve.number_of_nodes(), r),
          spheres_of(curve, number_of_directions, 0.9, r),
          medial_weight};
}

Sparse_matrix matrix_of(const Network& curve, double r = thickness)
{
  const Vector_field x = internal::coordinates(curve);
  CGAL::Volume_filling_curves::Curve_flow_parameters parameters;
  parameters.preconditioner = Preconditioner::CONTACT;
  return internal::preconditioner(parameters, curve, x, internal::node_weights(curve, x),
                                  std::vector<double>(curve.number_of_nodes(), r),
                                  spheres_of(curve, number_of_directions, 0.9, r));
}

// three rows per node
Eigen::MatrixXd brute_force_contacts(const Network& curve)
{
  const Vector_field x = internal::coordinates(curve);
  const std::vector<double> weights = internal::node_weights(curve, x);
  const Medial_spheres spheres = spheres_of(curve, number_of_directions, 0.9, thickness);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * x.rows(), 3 * x.rows());
  for(std::size_t c = 0; c < spheres.circles().size(); ++c)
    for(std::size_t l = 0; l < number_of_directions; ++l) {
      const std::size_t v = spheres.circles()[c].node, w = spheres.touching_node(c, l);
      if(w == Medial_spheres::no_node || curve.is_pinned(v)) continue;
      const double share = spheres.circles()[c].share * (curve.is_pinned(w) ? 2 : 1);
      const auto a = static_cast<Eigen::Index>(v), b = static_cast<Eigen::Index>(w);
      const Eigen::Vector3d u = (x.row(b) - x.row(a)).normalized();
      const Eigen::Matrix3d block = medial_weight / (thickness * thickness) * weights[v] * share /
                                    (4 * number_of_directions) * u * u.transpose();
      matrix.block<3, 3>(3 * a, 3 * a) += block;
      matrix.block<3, 3>(3 * b, 3 * b) += block;
      matrix.block<3, 3>(3 * a, 3 * b) -= block;
      matrix.block<3, 3>(3 * b, 3 * a) -= block;
    }
  return matrix;
}

// Forces on unpinned nodes; the others are left out.
Eigen::MatrixXd without_pinned_nodes(Eigen::MatrixXd matrix, const Network& curve)
{
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) {
    if(!curve.is_pinned(v)) continue;
    const auto a = static_cast<Eigen::Index>(v);
    matrix.middleRows(3 * a, 3).setZero();
    matrix.middleCols(3 * a, 3).setZero();
  }
  return matrix;
}

Eigen::VectorXd flat(const Vector_field& field)
{
  return Eigen::Map<const Eigen::VectorXd>(field.data(), field.size());
}

// zero at pinned nodes
Vector_field free_field(const Network& curve, Random& random)
{
  Vector_field field = random_field(curve.number_of_nodes(), random);
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    if(curve.is_pinned(v)) internal::set_row(field, v, Vector());
  return field;
}

std::vector<Network> some_curves()
{
  Random random(1);
  std::vector<Network> curves = {internal::closed_network({random_polygon(50, random)}),
                                 junctions_and_ends(40, random), path(random_polygon(30, random))};
  curves[2].pin_ends();
  for(std::size_t v = 5; v < 9; ++v) curves[1].set_pinned(v);
  return curves;
}

TEST(Contact_stiffness, is_the_sum_over_all_spheres_that_touch_a_node)
{
  Random random(2);
  for(const Network& curve : some_curves()) {
    const Eigen::MatrixXd matrix = without_pinned_nodes(brute_force_contacts(curve), curve);
    const Vector_field field = free_field(curve, random);
    Vector_field image = Vector_field::Zero(field.rows(), 3);
    contacts_of(curve).add_product(field, image);
    const Eigen::VectorXd expected = matrix * flat(field);
    EXPECT_GT(expected.norm(), 0);
    EXPECT_LT((flat(image) - expected).norm(), 1e-12 * expected.norm());
  }
}

// A node at the origin, and one that goes away from it: the force that its spheres exert on the
// first one grows by twice the stiffness, as the second one's count for the other half.
TEST(Contact_stiffness, is_half_of_what_a_force_changes_by)
{
  constexpr double way = 1e-6, length = 0.8 * thickness;
  const Network curve = path({{0, 0, 0}, {0.5, 0.3, 0.1}}); // whose positions do not matter
  const Vector u = Vector(1, 0.4, 0.3).normalized();
  const std::vector<double> weights = {1, 0}, r = {thickness, thickness};
  const auto spheres_at = [&](double distance) {
    Medial_spheres spheres({internal::Node_circle(0, Vector(0, 0, 1), 1)}, number_of_directions);
    for(std::size_t l = 0; l < number_of_directions; ++l) {
      const double cosine = spheres.direction(0, l).dot(u);
      const bool is_contact = distance < 2 * 0.9 * thickness * cosine;
      spheres.set(0, l, is_contact ? distance / (2 * cosine) : 0.9 * thickness,
                  is_contact ? 1 : Medial_spheres::no_node);
    }
    return spheres;
  };
  const auto force = [&](double distance) {
    Vector sum;
    const Medial_spheres spheres = spheres_at(distance);
    for(std::size_t l = 0; l < number_of_directions; ++l)
      sum += spheres.radius(0, l) * spheres.direction(0, l);
    return medial_weight / (thickness * thickness) / number_of_directions * sum.dot(u);
  };
  Vector_field x = Vector_field::Zero(2, 3), field = x, image = x;
  internal::set_row(x, 1, length * u);
  internal::set_row(field, 1, u);
  Contact_stiffness(curve, x, weights, r, spheres_at(length), medial_weight)
      .add_product(field, image);
  const double change = (force(length + way) - force(length)) / way;
  EXPECT_GT(change, 0);
  EXPECT_NEAR(-2 * internal::row(image, 0).dot(u), change, 1e-6 * change);
  EXPECT_NEAR(2 * internal::row(image, 1).dot(u), change, 1e-6 * change);
}

TEST(Contact_stiffness, is_none_where_nothing_touches)
{
  EXPECT_FALSE(contacts_of(path({{0, 0, 0}, {1, 0, 0}})).has_contacts());
  EXPECT_FALSE(Contact_stiffness().has_contacts());
}

TEST(Direction_solver, solves_with_contacts_up_to_a_hundredth)
{
  Random random(3);
  std::vector<Network> curves = some_curves();
  curves.push_back(internal::closed_network({random_polygon(300, random)}));
  for(const Network& curve : curves) {
    const Sparse_matrix lower = matrix_of(curve);
    const Eigen::MatrixXd one = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
    Eigen::MatrixXd matrix = without_pinned_nodes(brute_force_contacts(curve), curve);
    for(Eigen::Index a = 0; a < one.rows(); ++a)
      for(Eigen::Index b = 0; b < one.rows(); ++b)
        matrix.block<3, 3>(3 * a, 3 * b) += one(a, b) * Eigen::Matrix3d::Identity();
    const Vector_field b = free_field(curve, random);
    const Vector_field d = internal::Direction_solver()(lower, b, contacts_of(curve));
    EXPECT_LT((matrix * flat(d) - flat(b)).norm(), 1.01e-2 * b.norm());
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
      EXPECT_TRUE(!curve.is_pinned(v) || internal::row(d, v) == Vector());
  }
}

// The preconditioner has the unit 1 / length, directions have that of a length.
TEST(Direction_solver, scales_with_contacts_by_powers_of_two)
{
  Random random(4);
  const Network ring = internal::closed_network({random_polygon(100, random)});
  const Vector_field b = random_field(100, random);
  const Vector_field expected = internal::Direction_solver()(matrix_of(ring), b, contacts_of(ring));
  for(double scale : {std::ldexp(1., -60), 2., std::ldexp(1., 60)}) {
    const Network scaled = transformed(ring, scale);
    const double r = scale * thickness;
    EXPECT_EQ(internal::Direction_solver()(matrix_of(scaled, r), b, contacts_of(scaled, r)),
              Vector_field(scale * expected));
  }
}

} // namespace test_contact_stiffness
