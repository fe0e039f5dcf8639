// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Meshes of any type are domains, and kernels are traits.

#include "support/fill_test_support.h"

#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_fill_mesh {

using namespace fill_test;
namespace np = CGAL::Volume_filling_curves::parameters;
using Surface_mesh = CGAL::Surface_mesh<Point>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

template <typename Mesh>
Mesh tetrahedron()
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  return mesh;
}

template <typename Network>
std::vector<Point> points(const Network& curve)
{
  std::vector<Point> result;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) result.push_back(curve.point(v));
  return result;
}

const auto few_steps = np::thickness(0.1).number_of_iterations(5);

template <typename Mesh>
std::vector<Point> filled()
{
  Curve curve;
  VFC::fill(curve, tetrahedron<Mesh>(), few_steps);
  return points(curve);
}

TEST(Fill_mesh, fills_the_inside_of_any_mesh)
{
  const VFC::Triangle_mesh_domain_3 domain(tetrahedron<Surface_mesh>());
  Curve curve;
  VFC::fill(curve, domain, few_steps);
  expect_inside(curve, domain);
  EXPECT_EQ(filled<Surface_mesh>(), points(curve));
  EXPECT_EQ(filled<Polyhedron>().size(), curve.number_of_nodes());
}

// A model of `VolumeFillingDomainWithSurface_3` and no more.
class Archetype
{
  using Mesh_domain = VFC::Triangle_mesh_domain_3<Kernel>;

public:
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Vector_3 Vector_3;

  explicit Archetype(Mesh_domain domain)
      : m_domain(std::make_unique<Mesh_domain>(std::move(domain)))
  {}

  CGAL::Bbox_3 bbox() const { return m_domain->bbox(); }
  bool is_inside(const Point_3& p) const { return m_domain->is_inside(p); }
  bool is_triangle_inside(const Point_3& p, const Point_3& q, const Point_3& r) const
  {
    return m_domain->is_triangle_inside(p, q, r);
  }
  double distance(const Point_3& p) const { return m_domain->distance(p); }
  double distance_along(const Point_3& p, const Vector_3& direction, double limit) const
  {
    return m_domain->distance_along(p, direction, limit);
  }

  Archetype scaled(double factor) const { return Archetype(m_domain->scaled(factor)); }
  double distance_up_to(const Point_3& p, double limit) const
  {
    return m_domain->distance_up_to(p, limit);
  }
  template <typename Rays>
  void shorten(Rays& rays) const
  {
    m_domain->shorten(rays);
  }
  std::size_t part(const Point_3& p) const { return m_domain->part(p); }
  const std::vector<CGAL::Bbox_3>& part_boxes() const { return m_domain->part_boxes(); }

private:
  std::unique_ptr<Mesh_domain> m_domain;
};

TEST(Fill_mesh, asks_a_domain_with_a_surface_what_it_asks_a_mesh)
{
  const VFC::Triangle_mesh_domain_3 domain(tetrahedron<Surface_mesh>());
  for(const double factor : {1., std::ldexp(1., 150)}) {
    Curve curve, same;
    const auto steps = np::thickness(0.1 * factor).number_of_iterations(5);
    VFC::fill(curve, domain.scaled(factor), steps);
    VFC::fill(same, Archetype(domain.scaled(factor)), steps);
    EXPECT_EQ(points(same), points(curve));
  }
}

TEST(Fill_mesh, takes_a_map_of_points)
{
  Surface_mesh mesh = tetrahedron<Surface_mesh>();
  auto doubled = mesh.add_property_map<Surface_mesh::Vertex_index, Point>("v:doubled").first;
  for(const auto v : mesh.vertices())
    doubled[v] = Point(2 * mesh.point(v).x(), 2 * mesh.point(v).y(), 2 * mesh.point(v).z());
  Curve curve, large;
  VFC::fill(curve, mesh, few_steps);
  VFC::fill(large, mesh, np::thickness(0.2).number_of_iterations(5).vertex_point_map(doubled));
  ASSERT_EQ(large.number_of_nodes(), curve.number_of_nodes());
  EXPECT_EQ(large.point(0).x(), 2 * curve.point(0).x());
}

TEST(Fill_mesh, takes_a_struct_of_parameters)
{
  VFC::Filling_parameters<> parameters;
  parameters.thickness = 0.1;
  parameters.number_of_iterations = 5;
  Curve curve;
  VFC::fill(curve, tetrahedron<Surface_mesh>(), parameters);
  EXPECT_EQ(points(curve), filled<Surface_mesh>());
}

TEST(Fill_mesh, takes_curves_whose_traits_are_a_kernel)
{
  VFC::Curve_network_3<Kernel> curve;
  VFC::fill(curve, tetrahedron<Surface_mesh>(), few_steps);
  EXPECT_EQ(points(curve), filled<Surface_mesh>());
}

TEST(Deduction_guides, find_the_traits_of_points)
{
  const VFC::Triangle_mesh_domain_3 domain(tetrahedron<Polyhedron>());
  const VFC::Domain_samples_3 samples(domain, 10);
  static_assert(std::is_same_v<decltype(domain), const VFC::Triangle_mesh_domain_3<Kernel>>);
  static_assert(
      std::is_same_v<decltype(samples),
                     const VFC::Domain_samples_3<Traits, VFC::Triangle_mesh_domain_3<Kernel>>>);
  EXPECT_EQ(samples.points().size(), 10u);
}

} // namespace test_fill_mesh
