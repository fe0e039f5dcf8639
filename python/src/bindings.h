// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PYTHON_BINDINGS_H
#define VFC_PYTHON_BINDINGS_H

#include <pybind11/pybind11.h>

namespace vfc_python {

// Each adds what its file binds to the module.
void bind_arcs(pybind11::module_& module);
void bind_checks(pybind11::module_& module);
void bind_curves(pybind11::module_& module);
void bind_domains(pybind11::module_& module);
void bind_files(pybind11::module_& module);
void bind_filling(pybind11::module_& module);
void bind_generators(pybind11::module_& module);
void bind_identification(pybind11::module_& module);
void bind_measures(pybind11::module_& module);
void bind_meshes(pybind11::module_& module);
void bind_simplification(pybind11::module_& module);
void bind_untangling(pybind11::module_& module);
void bind_verification(pybind11::module_& module);

} // namespace vfc_python

#endif // VFC_PYTHON_BINDINGS_H
