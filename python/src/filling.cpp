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
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace vfc_python {

namespace {

using Thickness = std::function<double(const Point&)>;
using Direction = std::function<internal::Field_vector(const Point&)>;

bool is_array(const py::handle& given)
{
  return py::isinstance<py::array>(given) && py::reinterpret_borrow<py::array>(given).ndim() > 0;
}

const Mesh& mesh_with_values(const Doubles& values, const Domain& domain, const char* name)
{
  if(!domain.mesh)
    throw std::invalid_argument(
        "an array of thicknesses or directions has a row per vertex of a mesh, "
        "but the domain is no mesh; a function of a point can be given");
  const auto number = static_cast<std::size_t>(values.shape(0));
  if(number != domain.mesh->number_of_vertices())
    throw std::invalid_argument(std::string(name) + " has " + std::to_string(number) +
                                " rows, but the mesh has " +
                                std::to_string(domain.mesh->number_of_vertices()) + " vertices");
  return *domain.mesh;
}

Thickness thickness_at_vertices(const Doubles& values, const Domain& domain)
{
  if(values.ndim() != 1) throw std::invalid_argument("thickness must have the shape (n,)");
  return VFC::Mesh_thickness_field_3<>(mesh_with_values(values, domain, "thickness"),
                                       values.cast<std::vector<double>>());
}

// One direction, or one per vertex.
Direction direction_of(const Doubles& values, const Domain& domain)
{
  if(values.ndim() == 1 && values.shape(0) == 3) {
    const Point p = point_of(values);
    return [u = std::array<double, 3>{p.x(), p.y(), p.z()}](const Point&) { return u; };
  }
  if(values.ndim() != 2 || values.shape(1) != 3)
    throw std::invalid_argument("direction_field must have the shape (n, 3) or (3,)");
  return VFC::Mesh_direction_field_3<>(mesh_with_values(values, domain, "direction_field"),
                                       values.cast<std::vector<std::array<double, 3>>>());
}

// Takes an array out of the options, and hands it to a function.
template <typename Set>
void take_array(py::dict& options, const char* name, const Set& set)
{
  const py::object given = options.attr("get")(name);
  if(!is_array(given)) return;
  options.attr("pop")(name);
  set(given.cast<Doubles>());
}

VFC::Filling_parameters<Point> filling_parameters(const py::dict& given, const Domain& domain)
{
  py::dict options(given.attr("copy")());
  Thickness thickness;
  Direction direction;
  take_array(options, "thickness",
             [&](const Doubles& values) { thickness = thickness_at_vertices(values, domain); });
  take_array(options, "direction_field",
             [&](const Doubles& values) { direction = direction_of(values, domain); });
  auto parameters = parameters_of<VFC::Filling_parameters<Point>>(options);
  if(thickness) parameters.thickness_field = thickness;
  if(direction) parameters.direction_field = direction;
  return parameters;
}

// Replaces the curve, which may be empty, by the result.
py::dict fill(Curve& curve,
              const Domain& domain,
              const py::dict& given,
              VFC::Isotopy_certificate* certificate,
              const py::object& progress)
{
  auto parameters = filling_parameters(given, domain);
  Run_observer observer(progress);
  parameters.progress = std::ref(observer);
  parameters.certificate = certificate;
  VFC::Filling_result<Point> result;
  {
    const Interpreter_unlock unlock;
    result = std::visit(
        [&](const auto& inside) {
          return VFC::fill<CGAL::Parallel_if_available_tag>(curve, inside, parameters);
        },
        domain.inside);
  }
  return to_python(result);
}

// Of a number, a function of a point, or an array.
Thickness thickness_of(const py::object& given, const Domain& domain)
{
  if(PyCallable_Check(given.ptr())) return From_python<Thickness>::value(given);
  if(is_array(given)) return thickness_at_vertices(given.cast<Doubles>(), domain);
  const double r = PyFloat_AsDouble(given.ptr());
  if(PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    throw py::type_error("thickness is neither a number, nor a function, nor an array");
  }
  if(!(r > 0)) throw std::invalid_argument("thickness is not positive");
  return [r](const Point&) { return r; };
}

template <typename Inside>
VFC::Coverage coverage_of(const Curve& curve,
                          const Inside& inside,
                          const Thickness& thickness,
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
      samples, internal::sample_distances<CGAL::Parallel_if_available_tag>(curve, samples, &watch),
      thickness);
}

py::dict coverage(const Curve& curve,
                  const Domain& domain,
                  const py::object& thickness,
                  std::size_t number_of_samples,
                  std::size_t seed,
                  const py::object& progress)
{
  const Thickness r = thickness_of(thickness, domain);
  const auto measure = [&](internal::Run_watch* watch) {
    return std::visit(
        [&](const auto& inside) {
          return coverage_of(curve, inside, r, number_of_samples, seed, *watch);
        },
        domain.inside);
  };
  return to_python(interruptible(measure, progress));
}

} // namespace

void bind_filling(py::module_& module)
{
  module.def("fill", &fill);
  module.def("coverage", &coverage);
}

} // namespace vfc_python
