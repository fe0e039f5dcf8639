// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "bindings.h"
#include "options.h"
#include "results.h" // generated

#include <CGAL/Volume_filling_curves/Mesh_fields_3.h>
#include <CGAL/Volume_filling_curves/fill.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace vfc_python {

namespace {

// The inside of a closed mesh, and the mesh, for fields that are given at its vertices.
struct Domain
{
  explicit Domain(Mesh m) : mesh(std::move(m)), inside(mesh) {}

  Mesh mesh;
  VFC::Triangle_mesh_domain_3<> inside;
};

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
void set_fields(VFC::Filling_parameters<Point>& parameters, py::dict& options, const Mesh& mesh)
{
  if(const Doubles values = take_array(options, "thickness"); values.size() > 0)
    parameters.thickness_field = function_of_field<VFC::Mesh_thickness_field_3<>>(
        mesh, values.cast<std::vector<double>>());
  if(const Doubles values = take_array(options, "direction_field"); values.size() > 0)
    parameters.direction_field = function_of_field<VFC::Mesh_direction_field_3<>>(
        mesh, values.cast<std::vector<std::array<double, 3>>>());
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
  set_fields(fields, options, domain.mesh);
  auto parameters = parameters_of<VFC::Filling_parameters<Point>>(options);
  if(fields.thickness_field) parameters.thickness_field = fields.thickness_field;
  if(fields.direction_field) parameters.direction_field = fields.direction_field;
  Run_observer observer(progress);
  parameters.progress = std::ref(observer);
  parameters.certificate = certificate;
  VFC::Filling_result<Point> result;
  {
    const py::gil_scoped_release unlock;
    result = VFC::fill<CGAL::Parallel_if_available_tag>(curve, domain.inside, parameters);
  }
  return to_python(result);
}

// The curve's nodes and edges that are not strictly inside.
py::tuple outside(const Curve& curve, const Domain& domain)
{
  VFC::Containment result;
  {
    const py::gil_scoped_release unlock;
    result = VFC::containment(curve, domain.inside);
  }
  return py::make_tuple(result.outside_nodes, result.outside_edges);
}

py::dict coverage(const Curve& curve,
                  const Domain& domain,
                  double thickness,
                  std::size_t number_of_samples,
                  std::size_t seed)
{
  VFC::Coverage result;
  {
    const py::gil_scoped_release unlock;
    const VFC::Domain_samples_3<Curve::Traits, VFC::Triangle_mesh_domain_3<>> samples(
        domain.inside, number_of_samples, seed);
    result = VFC::coverage(
        samples, VFC::sample_distances<CGAL::Parallel_if_available_tag>(curve, samples), thickness);
  }
  return to_python(result);
}

} // namespace

void bind_filling(py::module_& module)
{
  py::class_<Domain>(module, "Domain")
      .def(py::init([](const Doubles& vertices, const Integers& faces) {
        Mesh mesh = mesh_of(vertices, faces);
        const py::gil_scoped_release unlock;
        return Domain(std::move(mesh));
      }));
  module.def("fill", &fill);
  module.def("outside", &outside);
  module.def("coverage", &coverage);
}

} // namespace vfc_python
