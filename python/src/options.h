// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PYTHON_OPTIONS_H
#define VFC_PYTHON_OPTIONS_H

#include "Run_observer.h"
#include "Shared_function.h"
#include "arrays.h"
#include "enumerations.h" // generated

#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/parameters/parameter_tables.h>

#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <array>
#include <functional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

// Keyword arguments fill the structs of parameters by the tables that named parameters are read
// with, so that each parameter of the library is one here, with the same name. A keyword that no
// table knows is a TypeError, a value out of its range a ValueError.

namespace vfc_python {

namespace internal = VFC::internal;

// A parameter that no value from Python can set: it is an argument of its own, or has none.
template <typename Value>
constexpr bool is_set_elsewhere = std::is_pointer_v<Value>;
template <>
inline constexpr bool is_set_elsewhere<std::function<bool(const VFC::Run_progress&)>> = true;
template <>
inline constexpr bool is_set_elsewhere<std::function<void(const VFC::Run_checkpoint&)>> = true;

template <typename Value>
struct From_python
{
  static Value value(const py::handle& given) { return given.cast<Value>(); }
};

template <>
struct From_python<std::function<double(const Point&)>>
{
  static std::function<double(const Point&)> value(const py::handle& given)
  {
    if(!PyCallable_Check(given.ptr())) throw py::cast_error();
    return [f = Shared_function(py::reinterpret_borrow<py::object>(given))](const Point& p) {
      return f.call<double>(p);
    };
  }
};

template <>
struct From_python<std::function<internal::Field_vector(const Point&)>>
{
  static std::function<internal::Field_vector(const Point&)> value(const py::handle& given)
  {
    if(!PyCallable_Check(given.ptr())) throw py::cast_error();
    return [f = Shared_function(py::reinterpret_borrow<py::object>(given))](const Point& p) {
      return internal::Field_vector(f.call<std::array<double, 3>>(p));
    };
  }
};

// Each port is x, y, z, or these and the three coordinates of a direction.
template <>
struct From_python<std::vector<VFC::Port<Point>>>
{
  static std::vector<VFC::Port<Point>> value(const py::handle& given)
  {
    std::vector<VFC::Port<Point>> ports;
    for(const auto& x : given.cast<std::vector<std::vector<double>>>()) {
      if(x.size() != 3 && x.size() != 6)
        throw std::invalid_argument("ports: a port has " + std::to_string(x.size()) +
                                    " coordinates, but must have 3 or 6");
      VFC::Port<Point> port{Point(x[0], x[1], x[2])};
      if(x.size() == 6) port.direction = {x[3], x[4], x[5]};
      ports.push_back(port);
    }
    return ports;
  }
};

// A number of things, of anything that Python takes for an integer, such as numpy.int64.
inline std::size_t count_of(const std::string& name, const py::handle& given)
{
  if(!PyIndex_Check(given.ptr())) throw py::cast_error();
  const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(given.ptr()));
  if(!number) throw py::error_already_set();
  const auto refuse = [&](const char* reason) {
    throw std::invalid_argument(name + " is " + py::str(number).cast<std::string>() +
                                ", but must " + reason);
  };
  if(number < py::int_(0)) refuse("not be negative");
  const std::size_t count = PyLong_AsSize_t(number.ptr());
  if(PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    refuse("be less than 2^64");
  }
  return count;
}

// Returns whether the value could be converted.
template <typename Parameters, typename Row>
bool set_by_row(Parameters& parameters, const Row& row, const py::handle& given)
{
  using Value = typename Row::Value;
  if constexpr(is_set_elsewhere<Value>)
    return false;
  else {
    try {
      const std::string name = VFC::internal_np::name_of(typename Row::Tag());
      if constexpr(std::is_same_v<Value, std::size_t>)
        parameters.*row.member = count_of(name, given);
      else if constexpr(std::is_enum_v<Value>)
        parameters.*row.member = enumerator<Value>(name, given.cast<std::string>());
      else
        parameters.*row.member = From_python<Value>::value(given);
    } catch(const py::cast_error&) {
      return false;
    }
    return true;
  }
}

template <typename Parameters>
void set_option(Parameters& parameters, const std::string& name, const py::handle& given)
{
  bool is_known = false, is_set = false;
  const auto try_row = [&](const auto& row) {
    using Row = std::decay_t<decltype(row)>;
    if(is_set || is_set_elsewhere<typename Row::Value> ||
       name != VFC::internal_np::name_of(typename Row::Tag()))
      return;
    is_known = true;
    is_set = set_by_row(parameters, row, given);
  };
  std::apply([&](const auto&... row) { (try_row(row), ...); },
             internal::parameter_table<Parameters>());
  if(!is_known) throw py::type_error("unexpected keyword argument '" + name + "'");
  if(!is_set)
    throw py::type_error(name + " has a value of the type " +
                         py::str(py::type::of(given).attr("__name__")).cast<std::string>() +
                         ", which it cannot have");
}

// The parameters that are given; one that is None has its default.
template <typename Parameters>
Parameters parameters_of(const py::dict& options)
{
  Parameters parameters;
  for(const auto& [name, value] : options)
    if(!value.is_none()) set_option(parameters, name.template cast<std::string>(), value);
  internal::check_parameters(parameters);
  return parameters;
}

} // namespace vfc_python

#endif // VFC_PYTHON_OPTIONS_H
