// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PYTHON_TO_PYTHON_H
#define VFC_PYTHON_TO_PYTHON_H

#include "arrays.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/internal/arcs/Arc_spline.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Link_identity.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Chain_identity.h>
#include <CGAL/Volume_filling_curves/untangle.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace vfc_python {

// Values that the members of results have. The structs themselves become dictionaries by generated
// functions of the same name.

inline py::object to_python(const std::string& value)
{
  return py::str(value);
}

inline py::object to_python(const Point& p)
{
  return array_of({p}).attr("__getitem__")(0);
}

inline py::object to_python(const std::vector<Point>& points)
{
  return array_of(points);
}

template <std::size_t count>
py::object to_python(const std::array<Point, count>& points)
{
  return array_of({points.begin(), points.end()});
}

template <typename Number, std::size_t count>
py::object to_python(const std::array<Number, count>& numbers)
{
  return py::cast(numbers);
}

template <typename Value, std::enable_if_t<std::is_arithmetic_v<Value>, int> = 0>
py::object to_python(Value value)
{
  return py::cast(value);
}

template <typename Value, std::enable_if_t<std::is_enum_v<Value>, int> = 0>
py::object to_python(Value value)
{
  return py::str(VFC::to_string(value));
}

// One member of each of many structs, as an array with a row for each.
template <typename Row, typename Member>
py::object array_of(const std::vector<Row>& rows, Member Row::*member)
{
  if constexpr(std::is_same_v<Member, Point>) {
    std::vector<Point> points;
    for(const Row& row : rows) points.push_back(row.*member);
    return array_of(points);
  } else if constexpr(std::is_same_v<Member, std::string>) {
    py::list texts;
    for(const Row& row : rows) texts.append(row.*member);
    return py::module_::import("numpy").attr("array")(texts, "str");
  } else {
    using Number = std::conditional_t<std::is_integral_v<Member>, std::int64_t, Member>;
    py::array_t<Number> numbers(static_cast<py::ssize_t>(rows.size()));
    for(std::size_t i = 0; i < rows.size(); ++i)
      numbers.mutable_at(static_cast<py::ssize_t>(i)) = static_cast<Number>(rows[i].*member);
    return numbers;
  }
}

py::dict to_python(const VFC::Empty_region_3<Point>& value);
py::dict to_python(const VFC::Shape_excess_3<Point>& value);
py::dict to_python(const VFC::Port_neck<Point>& value);
py::dict to_python(const std::vector<VFC::Arc_spline_piece<Point>>& rows);
py::dict to_python(const VFC::Arc_spline_path<Point>& value);
py::dict to_python(const VFC::Arc_conflict& value);
py::dict to_python(const std::vector<VFC::Chain_section>& rows);
py::dict to_python(const VFC::Closure_knot& value);
py::dict to_python(const VFC::Knot_share& value);

template <typename Value>
py::list to_python(const std::vector<Value>& values)
{
  py::list result;
  for(const Value& value : values) result.append(to_python(value));
  return result;
}

} // namespace vfc_python

#endif // VFC_PYTHON_TO_PYTHON_H
