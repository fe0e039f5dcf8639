// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PYTHON_RUN_OBSERVER_H
#define VFC_PYTHON_RUN_OBSERVER_H

#include "Interpreter_lock.h"

#include <CGAL/Volume_filling_curves/internal/parameters/watched.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <pybind11/pybind11.h>

#include <chrono>
#include <functional>
#include <utility>

namespace vfc_python {

namespace py = pybind11;
namespace VFC = CGAL::Volume_filling_curves;

// Takes None, or a function of a dictionary.
inline void require_function(const py::object& progress)
{
  if(!progress.is_none() && PyCallable_Check(progress.ptr()) == 0)
    throw py::type_error("progress is " + py::repr(progress).cast<std::string>() +
                         ", but must be a function of a dictionary");
}

// Whether work goes on after a function of its progress has returned this. Only False ends it, or
// NumPy's: functions return other values without a thought of that, such as 0 or an empty list.
inline bool goes_on(const py::object& answer)
{
  if(answer.is_none()) return true;
  const bool is_numpys = py::isinstance(answer, py::module_::import("numpy").attr("bool_"));
  return !(is_numpys || py::isinstance<py::bool_>(answer)) || answer.cast<bool>();
}

// The progress of a run that was started from Python: a function receives it as a dictionary and
// can end the run by returning False, and Ctrl-C ends the run by KeyboardInterrupt. The run itself
// goes on without the interpreter's lock, which is taken twenty times a second at most.
class Run_observer
{
public:
  // Takes None, or a function of a dictionary.
  explicit Run_observer(py::object function) : m_function(std::move(function))
  {
    require_function(m_function);
  }

  bool operator()(const VFC::Run_progress& progress)
  {
    const auto now = std::chrono::steady_clock::now();
    const bool is_new_stage = progress.stage != m_stage;
    if(now < m_next && !is_new_stage) return true;
    m_stage = progress.stage;
    m_next = now + std::chrono::milliseconds(50);
    const Interpreter_lock lock;
    if(PyErr_CheckSignals() != 0) throw py::error_already_set();
    if(m_function.is_none()) return true;
    return goes_on(called(m_function, dictionary(progress)));
  }

private:
  static py::dict dictionary(const VFC::Run_progress& p)
  {
    py::dict d;
    d["stage"] = VFC::to_string(p.stage);
    d["fraction"] = p.fraction;
    d["iterations"] = p.iterations;
    d["nodes"] = p.nodes;
    d["length"] = p.length;
    d["gradient_norm"] = p.gradient_norm;
    d["seconds"] = p.seconds;
    d["thickness"] = p.thickness;
    d["expected_length"] = p.expected_length;
    d["expected_nodes"] = p.expected_nodes;
    d["expected_seconds"] = p.expected_seconds;
    return d;
  }

  py::object m_function;
  VFC::Run_stage m_stage = VFC::Run_stage::VERIFYING;
  std::chrono::steady_clock::time_point m_next;
};

// Calls a function of a watch without the interpreter's lock; Ctrl-C ends it where it asks the
// watch, or where the library asks the one of the thread.
template <typename Function>
auto interruptible(const Function& function, const py::object& progress = py::none())
{
  Run_observer observer(progress);
  const Interpreter_unlock unlock;
  return VFC::internal::measured(VFC::parameters::progress(std::ref(observer)),
                                 [&](VFC::internal::Run_watch* watch) {
                                   const VFC::internal::Watched_scope scope(watch);
                                   return function(watch);
                                 });
}

} // namespace vfc_python

#endif // VFC_PYTHON_RUN_OBSERVER_H
