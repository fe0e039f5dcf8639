// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PYTHON_SHARED_FUNCTION_H
#define VFC_PYTHON_SHARED_FUNCTION_H

#include "Interpreter_lock.h"
#include "arrays.h"

#include <memory>
#include <string>
#include <type_traits>

namespace vfc_python {

// A function of Python that is called from any thread, and let go with the interpreter's lock.
class Shared_function
{
public:
  explicit Shared_function(const py::object& function)
      : m_function(new py::object(function), [](py::object* f) {
          const Interpreter_lock lock;
          delete f;
        })
  {}

  template <typename Result>
  Result call(const Point& p) const
  {
    const Interpreter_lock lock;
    const py::object point =
        py::module_::import("numpy").attr("array")(py::make_tuple(p.x(), p.y(), p.z()));
    const py::object answer = called(*m_function, point);
    try {
      return answer.template cast<Result>();
    } catch(const py::cast_error&) {
      constexpr bool is_number = std::is_same_v<Result, double>;
      throw py::type_error("the function returned " + py::repr(answer).cast<std::string>() +
                           " at " + py::repr(point).cast<std::string>() + ", but must return " +
                           (is_number ? "a number" : "three numbers"));
    }
  }

private:
  std::shared_ptr<py::object> m_function;
};

} // namespace vfc_python

#endif // VFC_PYTHON_SHARED_FUNCTION_H
