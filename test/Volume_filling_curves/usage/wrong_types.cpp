// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Types that are no models of their concepts: the compiler is to refuse each with the sentence that
// stands before it, see wrong_types.cmake.

#include <CGAL/Volume_filling_curves/untangle_in_domain.h>

#include <array>
#include <vector>

namespace wrong_types {

using namespace CGAL::Volume_filling_curves;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Network = Curve_network_3<>;

struct Traits_without_predicates
{
  using Point_3 = Kernel::Point_3;
  using Vector_3 = Kernel::Vector_3;
  Kernel::Construct_point_3 construct_point_3_object() const;
};

struct Domain_without_distances
{
  using Point_3 = Kernel::Point_3;
  using Vector_3 = Kernel::Vector_3;
  CGAL::Bbox_3 bbox() const;
  bool is_inside(const Point_3&) const;
  bool is_triangle_inside(const Point_3&, const Point_3&, const Point_3&) const;
};

struct Silent_visitor
{
  template <typename Flow>
  void on_start(const Flow&);
};

struct Place
{};

// refused: CurveFlowTraits_3 requires orientation_3_object()
std::size_t count(const Curve_network_3<Traits_without_predicates>& curves)
{
  return curves.number_of_nodes();
}

void untangle_wrongly(Network& curves, const Domain_without_distances& domain)
{
  namespace VFC = CGAL::Volume_filling_curves;
  const Isotopy_certificate certificate;
  std::array<Point, 4> points{};
  std::vector<Place> places;
  std::vector<int> numbers;

  // refused: VolumeFillingDomain_3 requires distance(point)
  // refused: VolumeFillingDomain_3 requires Vector_3 and distance_along(point, vector, limit)
  untangle(curves, domain);
  // refused: VolumeFillingDomain_3 requires is_inside(point), FaceListGraph faces(mesh)
  untangle(curves, numbers);
  // refused: CurveFlowVisitor requires on_iteration(flow)
  // refused: CurveFlowVisitor requires bool go_further(flow)
  untangle(curves, VFC::parameters::visitor(Silent_visitor()));
  // refused: SequenceContainer requires clear()
  untangle(points);
  // refused: Points of polylines must be those of a kernel of CGAL
  untangle(places);
  // refused: the value of the named parameter certificate does not convert
  untangle(curves, VFC::parameters::certificate(certificate));
  // refused: the value of the named parameter thickness does not convert
  untangle(curves, VFC::parameters::thickness([](const Point&) { return 1.; }));
  // refused: this function does not take the named parameter wall
  untangle(curves, VFC::parameters::wall(Wall::COVER));
  // refused: this function does not take the named parameter with this Tag
  untangle(curves, CGAL::parameters::verbose(true));
}

} // namespace wrong_types
