// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PYTHON_INTERPRETER_LOCK_H
#define VFC_PYTHON_INTERPRETER_LOCK_H

#include <pybind11/pybind11.h>

#include <chrono>
#include <optional>
#include <thread>
#ifdef __GLIBCXX__
#include <cxxabi.h>
#endif

// The interpreter's lock in daemon threads, which may outlive the interpreter. If a thread asks for
// the lock while the interpreter ends, Python up to 3.13 unwinds the thread's stack, and the first
// destructor or catch-all on the way aborts the process. Here the thread sleeps until the process
// has ended, as in Python 3.14.

namespace vfc_python {

namespace py = pybind11;

// Calls a function that may ask for the lock.
template <typename Function>
auto outliving_interpreter(const Function& function)
{
#ifdef __GLIBCXX__
  try {
    return function();
  } catch(const abi::__forced_unwind&) {
    for(;;) std::this_thread::sleep_for(std::chrono::hours(1));
  }
#else
  return function();
#endif
}

// Calls a function of Python with one argument.
inline py::object called(const py::object& function, const py::object& argument)
{
  PyObject* const answer = outliving_interpreter(
      [&] { return PyObject_CallFunctionObjArgs(function.ptr(), argument.ptr(), nullptr); });
  if(answer == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::object>(answer);
}

// Holds the lock, in any thread.
class Interpreter_lock
{
public:
  Interpreter_lock()
  {
    outliving_interpreter([this] { m_lock.emplace(); });
  }

private:
  std::optional<py::gil_scoped_acquire> m_lock;
};

// Releases the lock, which the thread holds before and afterwards.
class Interpreter_unlock
{
public:
  Interpreter_unlock() : m_thread(PyEval_SaveThread()) {}
  ~Interpreter_unlock()
  {
    outliving_interpreter([this] { PyEval_RestoreThread(m_thread); });
  }

  Interpreter_unlock(const Interpreter_unlock&) = delete;
  Interpreter_unlock& operator=(const Interpreter_unlock&) = delete;

private:
  PyThreadState* m_thread;
};

} // namespace vfc_python

#endif // VFC_PYTHON_INTERPRETER_LOCK_H
