// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Domain.h"
#include "Run_observer.h"
#include "Shared_function.h"
#include "bindings.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Implicit_domain_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>

#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <pybind11/stl.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace vfc_python {

namespace {

using Traits = Curve::Traits;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;
using Polygon_with_holes = CGAL::Polygon_with_holes_2<Kernel>;

Domain inside_of_mesh(const Doubles& vertices, const Integers& faces)
{
  const auto mesh = std::make_shared<const Mesh>(mesh_of(vertices, faces));
  return interruptible([&](internal::Run_watch*) {
    return Domain{Any_domain::of(VFC::Triangle_mesh_domain_3<>(*mesh)), mesh};
  });
}

Polygon polygon_of(const Doubles& corners)
{
  if(corners.ndim() != 2 || corners.shape(1) != 2)
    throw std::invalid_argument("the boundary of a polygon must have the shape (n, 2)");
  const auto x = corners.unchecked<2>();
  Polygon polygon;
  for(py::ssize_t i = 0; i < x.shape(0); ++i) polygon.push_back({x(i, 0), x(i, 1)});
  return polygon;
}

// The first boundary of each polygon is the outer one, the others are holes.
Domain inside_of_polygons(const std::vector<std::vector<Doubles>>& boundaries)
{
  std::vector<Polygon_with_holes> polygons;
  for(const auto& rings : boundaries) {
    if(rings.empty()) throw std::invalid_argument("a polygon has no boundary");
    Polygon_with_holes polygon(polygon_of(rings[0]));
    for(std::size_t i = 1; i < rings.size(); ++i) polygon.add_hole(polygon_of(rings[i]));
    polygons.push_back(std::move(polygon));
  }
  return interruptible([&](internal::Run_watch*) {
    return Domain{Planar_domain(polygons), nullptr};
  });
}

Domain inside_of_box(const Doubles& low, const Doubles& high)
{
  return {Any_domain::of(VFC::Box_domain_3<Traits>(point_of(low), point_of(high))), nullptr};
}

Domain inside_of_ball(const Doubles& center, double radius)
{
  return {Any_domain::of(VFC::Ball_domain_3<Traits>(point_of(center), radius)), nullptr};
}

Domain where_negative(const py::object& function,
                      const Doubles& low,
                      const Doubles& high,
                      double lipschitz_bound)
{
  const auto value = [f = Shared_function(function)](const Point& p) { return f.call<double>(p); };
  const CGAL::Bbox_3 box = point_of(low).bbox() + point_of(high).bbox();
  return {
      Any_domain::of(VFC::Implicit_domain_3<decltype(value), Traits>(value, box, lipschitz_bound)),
      nullptr};
}

} // namespace

void bind_domains(py::module_& module)
{
  py::class_<Domain>(module, "Domain");
  module.def("inside_of_mesh", &inside_of_mesh);
  module.def("inside_of_polygons", &inside_of_polygons);
  module.def("inside_of_box", &inside_of_box);
  module.def("inside_of_ball", &inside_of_ball);
  module.def("where_negative", &where_negative);
}

} // namespace vfc_python
