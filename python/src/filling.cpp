// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Domain.h"
#include "bindings.h"
#include "options.h"
#include "results.h" // generated

#include <CGAL/Volume_filling_curves/Mesh_fields_3.h>
#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/fill.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <variant>
#include <vector>

namespace vfc_python {

namespace {

// Takes an array out of the options.
Doubles take_array(py::dict& options, const char* name)
{
  const py::object given = options.attr("get")(name);
  if(!py::isinstance<py::array>(given) && !PyList_Check(given.ptr())) return {};
  options.attr("pop")(name);
  return Doubles::ensure(given);
}

// A field at the vertices of a mesh, as a function that can be copied.
template <typename Field, typename Values>
auto function_of_field(const Mesh& mesh, const Values& values)
{
  return [field = std::make_shared<const Field>(mesh, values)](const Point& p) {
    return (*field)(p);
  };
}

// Fields that are arrays, with a row per vertex of the mesh.
void set_fields(VFC::Filling_parameters<Point>& parameters, py::dict& options, const Domain& domain)
{
  const Doubles thickness = take_array(options, "thickness");
  const Doubles directions = take_array(options, "direction_field");
  if(thickness.size() + directions.size() > 0 && !domain.mesh)
    throw std::invalid_argument(
        "an array of thicknesses or directions has a row per vertex of a mesh, but the domain is no "
        "mesh; a function of a point can be given");
  if(thickness.size() > 0)
    parameters.thickness_field = function_of_field<VFC::Mesh_thickness_field_3<>>(
        *domain.mesh, thickness.cast<std::vector<double>>());
  if(directions.size() > 0)
    parameters.direction_field = function_of_field<VFC::Mesh_direction_field_3<>>(
        *domain.mesh, directions.cast<std::vector<std::array<double, 3>>>());
}

// Replaces the curve, which may be empty, by the result.
py::dict fill(Curve& curve,
              const Domain& domain,
              const py::dict& given,
              VFC::Isotopy_certificate* certificate,
              const py::object& progress)
{
  py::dict options(given.attr("copy")());
  VFC::Filling_parameters<Point> fields;
  set_fields(fields, options, domain);
  auto parameters = parameters_of<VFC::Filling_parameters<Point>>(options);
  if(fields.thickness_field) parameters.thickness_field = fields.thickness_field;
  if(fields.direction_field) parameters.direction_field = fields.direction_field;
  Run_observer observer(progress);
  parameters.progress = std::ref(observer);
  parameters.certificate = certificate;
  VFC::Filling_result<Point> result;
  {
    const py::gil_scoped_release unlock;
    result = std::visit(
        [&](const auto& inside) {
          return VFC::fill<CGAL::Parallel_if_available_tag>(curve, inside, parameters);
        },
        domain.inside);
  }
  return to_python(result);
}

// The curve's nodes and edges that are not strictly inside.
py::tuple outside(const Curve& curve, const Domain& domain, const py::object& progress)
{
  const auto find = [&](internal::Run_watch* watch) {
    return std::visit(
        [&](const auto& inside) { return internal::find_containment(curve, inside, watch); },
        domain.inside);
  };
  const VFC::Containment result = interruptible(find, progress);
  return py::make_tuple(result.outside_nodes, result.outside_edges);
}

template <typename Inside>
VFC::Coverage coverage_of(const Curve& curve,
                          const Inside& inside,
                          double thickness,
                          std::size_t number_of_samples,
                          std::size_t seed,
                          internal::Run_watch& watch)
{
  const auto go_further = [&] {
    watch.check();
    return true;
  };
  const VFC::Domain_samples_3<Curve::Traits, Inside> samples(inside, number_of_samples, seed,
                                                             Curve::Traits(), go_further);
  return VFC::coverage(
      samples,
      internal::sample_distances<CGAL::Parallel_if_available_tag>(curve, samples, &watch),
      thickness);
}

py::dict coverage(const Curve& curve,
                  const Domain& domain,
                  double thickness,
                  std::size_t number_of_samples,
                  std::size_t seed,
                  const py::object& progress)
{
  const auto measure = [&](internal::Run_watch* watch) {
    return std::visit(
        [&](const auto& inside) {
          return coverage_of(curve, inside, thickness, number_of_samples, seed, *watch);
        },
        domain.inside);
  };
  return to_python(interruptible(measure, progress));
}

} // namespace

void bind_filling(py::module_& module)
{
  module.def("fill", &fill);
  module.def("outside", &outside);
  module.def("coverage", &coverage);
}

} // namespace vfc_python
