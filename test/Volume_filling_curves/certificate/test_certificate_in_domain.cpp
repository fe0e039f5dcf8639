// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/certificate_test_support.h"
#include "support/mesh_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <numeric>
#include <string>
#include <vector>

// Certificates of curves that stayed inside, and of those that did not.
namespace test_certificate_in_domain {

using namespace certificate_test;
using Mesh_domain = VFC::Triangle_mesh_domain_3<>;
using Point = Network::Point_3;

Network square(double size, const Point& center)
{
  std::vector<Point> points;
  for(const auto& [x, y] : {std::array<double, 2>{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    points.emplace_back(center.x() + size * x, center.y() + size * y, center.z());
  return {points, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
}

template <typename Domain>
Motion filling(const Domain& domain, const Network& start)
{
  Motion motion;
  motion.start = motion.end = start;
  VFC::fill(motion.end, domain,
            VFC::parameters::thickness(0.4).round_bends(false).number_of_iterations(30).certificate(
                std::ref(motion.certificate)));
  return motion;
}

// The motion, followed by moves of nodes, numbered as in the certificate, which only have to be
// isotopies.
Motion with_moves(const Motion& motion, const std::vector<Operation>& moves)
{
  Pieces pieces = take_apart(motion.certificate);
  pieces.operations.insert(pieces.operations.end(), moves.begin(), moves.end());
  Guard_replay replay(motion.start);
  EXPECT_EQ(replay(pieces.operations), pieces.operations.size());
  Motion result{motion.start, replay.curve(), {}};
  const internal::Canonical_curve end(result.end);
  pieces.trailer.nodes = end.points().size();
  pieces.trailer.edges = end.edges().size();
  pieces.trailer.curve = end.digest();
  result.certificate = put_together(pieces);
  return result;
}

template <typename Domain>
Certificate_verdict verdict_in(const Motion& motion, const Domain& domain)
{
  return verify_certificate(motion.certificate, motion.start, motion.end, domain);
}

TEST(Certificate_in_domain, of_a_filling_is_valid)
{
  const meshes::Mesh mesh = meshes::to_mesh(meshes::cube(4));
  const Motion motion = filling(Mesh_domain(mesh), square(0.5, Point(2, 2, 2)));
  EXPECT_GT(take_apart(motion.certificate).operations.size(), 1000u);
  EXPECT_TRUE(motion.verdict().is_valid);
  const Certificate_verdict verdict = verdict_in(motion, mesh);
  EXPECT_TRUE(verdict.is_valid) << verdict.operation << ": " << verdict.message;
  EXPECT_TRUE(verdict_in(motion, Mesh_domain(mesh)).is_valid);
}

// The polylines of a network.
std::vector<std::vector<Point>> polylines(const Network& curve)
{
  std::vector<std::vector<Point>> result;
  VFC::curve_network_to_polylines(curve, std::back_inserter(result));
  return result;
}

TEST(Certificate_verdict, is_a_sentence)
{
  const VFC::Ball_domain_3<> ball(Point(0, 0, 0), 2), smaller(Point(0, 0, 0), 1);
  const Motion motion = filling(ball, square(0.5, Point(0, 0, 0)));
  const Certificate_verdict verdict = verdict_in(motion, ball);
  const std::string operations = std::to_string(verdict.number_of_operations);
  EXPECT_EQ(verdict.sentence(), "verified: " + operations +
                                    " operations; the end is ambient isotopic to the start and "
                                    "never left the domain");
  EXPECT_EQ(motion.verdict().sentence("a.obj", "b.obj"),
            "verified: " + operations + " operations; b.obj is ambient isotopic to a.obj");
  const Certificate_verdict refused = verdict_in(motion, smaller);
  EXPECT_GT(refused.operation, 0u);
  EXPECT_EQ(refused.sentence(),
            "rejected: operation " + std::to_string(refused.operation) + ": " + refused.message);
  EXPECT_EQ(verify_certificate(motion.certificate, motion.end, motion.end).sentence(),
            "rejected: start: the certificate starts from another curve");
}

TEST(Certificate_in_domain, is_verified_for_polylines)
{
  const VFC::Ball_domain_3<> ball(Point(0, 0, 0), 1);
  Network curve;
  Isotopy_certificate certificate;
  const auto result = VFC::fill(
      curve, ball,
      VFC::parameters::thickness(0.4).number_of_iterations(3).certificate(std::ref(certificate)));
  EXPECT_TRUE(verify_certificate(certificate, result.start, curve, ball).is_valid);
  EXPECT_TRUE(verify_certificate(certificate, result.start, polylines(curve)).is_valid);
  EXPECT_TRUE(verify_certificate(certificate, result.start[0], polylines(curve)[0]).is_valid);
  EXPECT_FALSE(verify_certificate(certificate, polylines(curve), result.start).is_valid);
}

TEST(Certificate_in_domain, of_a_filled_ball_is_valid)
{
  const VFC::Ball_domain_3<> ball(Point(0, 0, 0), 2), smaller(Point(0, 0, 0), 1);
  const Motion motion = filling(ball, square(0.5, Point(0, 0, 0)));
  EXPECT_TRUE(verdict_in(motion, ball).is_valid);
  EXPECT_FALSE(verdict_in(motion, smaller).is_valid);
}

// Another domain than the one that was filled.
TEST(Certificate_in_domain, refuses_a_start_that_is_not_inside)
{
  const Motion motion =
      filling(Mesh_domain(meshes::to_mesh(meshes::cube(4))), square(0.5, Point(2, 2, 2)));
  EXPECT_EQ(verdict_in(motion, meshes::to_mesh(meshes::cube(1))).message,
            "start: node 0 is not inside the domain");
  // a wall between the nodes
  const auto hollow = meshes::to_mesh(meshes::voxels(
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}},
      1.3));
  const auto at_rest = [](double size, const Point& corner) {
    Motion still;
    still.start = still.end = square(size, corner);
    Guard guard(still.end);
    guard.start_recording();
    still.certificate = guard.certificate();
    return still;
  };
  const Motion around = at_rest(1.2, Point(1.95, 1.95, 0.65));
  EXPECT_TRUE(verdict_in(around, hollow).is_valid);
  const Motion across = at_rest(0.7, Point(1.3, 1.3, 0.65));
  EXPECT_NE(verdict_in(across, hollow).message.find("is not inside the domain"), std::string::npos);
}

// Isotopies, but through the boundary; there and back again, which the end does not reveal.
TEST(Certificate_in_domain, refuses_a_forged_move_through_the_wall)
{
  const meshes::Mesh mesh = meshes::to_mesh(meshes::cube(4));
  Motion motion;
  motion.start = motion.end = square(1, Point(2, 2, 2));
  Guard guard(motion.end);
  guard.start_recording();
  ASSERT_TRUE(guard.move_node(0, Point(0.5, 0.5, 3)));
  motion.certificate = guard.certificate();
  ASSERT_TRUE(verdict_in(motion, mesh).is_valid);
  const auto moved = [&](double x) { return Operation{Kind::MOVE, 0, 0, {x, 0.5, 3}}; };
  for(const double x : {-1e-9, 0., -3., -1e100}) {
    const Motion forged = with_moves(motion, {moved(x), moved(0.5)});
    EXPECT_TRUE(forged.verdict().is_valid);
    const Certificate_verdict verdict = verdict_in(forged, mesh);
    EXPECT_EQ(verdict.message, "moving node 0: the curve would leave the domain");
    EXPECT_EQ(verdict.operation, 2u);
    EXPECT_FALSE(verdict_in(forged, Mesh_domain(mesh)).is_valid);
  }
  EXPECT_TRUE(verdict_in(with_moves(motion, {moved(1e-9), moved(0.5)}), mesh).is_valid);
}

// A caller's own curve: a network with another node, which has no edge.
struct With_lone_node
{
  const Network& network;
  Point lone;

  std::vector<std::size_t> nodes() const
  {
    std::vector<std::size_t> result(network.number_of_nodes() + 1);
    std::iota(result.begin(), result.end(), std::size_t(0));
    return result;
  }
  auto edges() const { return network.edges(); }
  Point point(std::size_t v) const
  {
    return v < network.number_of_nodes() ? network.point(v) : lone;
  }
  std::size_t source(std::size_t e) const { return network.source(e); }
  std::size_t target(std::size_t e) const { return network.target(e); }
};

// Nothing would stop such a node from going anywhere.
TEST(Certificate_in_domain, has_no_nodes_without_an_edge)
{
  const meshes::Mesh mesh = meshes::to_mesh(meshes::cube(4));
  Network network = square(1, Point(2, 2, 2));
  Guard guard(network);
  guard.start_recording();
  const With_lone_node start{network, Point(3.5, 2, 2)}, end{network, Point(5, 2, 2)};
  EXPECT_TRUE(verify_certificate(guard.certificate(), start, end, mesh).is_valid);
  const internal::Canonical_curve first(start), last(end);
  Pieces forged;
  forged.header.nodes = first.points().size();
  forged.header.edges = first.edges().size();
  forged.header.components = first.number_of_components();
  forged.header.curve = first.digest();
  forged.operations.push_back({Kind::MOVE, 4, 0, {5, 2, 2}});
  forged.trailer.nodes = last.points().size();
  forged.trailer.edges = last.edges().size();
  forged.trailer.curve = last.digest();
  const Certificate_verdict verdict = verify_certificate(put_together(forged), start, end, mesh);
  EXPECT_EQ(verdict.message, "moving node 4: there is no node 4");
}

TEST(Certificate_in_domain, refuses_forged_insertions_and_removals)
{
  const meshes::Mesh mesh = meshes::to_mesh(meshes::cube(4));
  Motion motion;
  motion.start = motion.end = square(1, Point(2, 2, 2));
  Guard guard(motion.end);
  guard.start_recording();
  motion.certificate = guard.certificate();
  const Operation insertion = {Kind::INSERT, 0, 1, {-1, 2, 2}}, removal = {Kind::REMOVE, 4, 0, {}};
  const Motion forged = with_moves(motion, {insertion, removal});
  EXPECT_TRUE(forged.verdict().is_valid);
  EXPECT_EQ(verdict_in(forged, mesh).operation, 1u);
  // the edge that stays when a node goes crosses the cavity that the curve went around
  meshes::Soup cavity = meshes::cube(1).inverted();
  for(auto& p : cavity.points) p = {p.x() + 1.5, p.y() + 1.5, p.z() + 1.5};
  const meshes::Mesh hollow = meshes::to_mesh(meshes::cube(4) + cavity);
  EXPECT_TRUE(verdict_in(motion, hollow).is_valid);
  const Motion shortened = with_moves(motion, {{Kind::REMOVE, 1, 0, {}}});
  EXPECT_TRUE(shortened.verdict().is_valid);
  EXPECT_EQ(verdict_in(shortened, hollow).message,
            "removing node 1: the curve would leave the domain");
}

} // namespace test_certificate_in_domain
