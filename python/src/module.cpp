// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "bindings.h"

#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/version.h>

PYBIND11_MODULE(_vfc, module)
{
  using CGAL::Volume_filling_curves::Run_interrupted;
  pybind11::register_exception<Run_interrupted>(module, "Interrupted", PyExc_RuntimeError);
  module.doc() = "The compiled part of vfc.";
  module.attr("__version__") = CGAL_VOLUME_FILLING_CURVES_VERSION;
  vfc_python::bind_arcs(module);
  vfc_python::bind_checks(module);
  vfc_python::bind_curves(module);
  vfc_python::bind_domains(module);
  vfc_python::bind_files(module);
  vfc_python::bind_filling(module);
  vfc_python::bind_generators(module);
  vfc_python::bind_identification(module);
  vfc_python::bind_measures(module);
  vfc_python::bind_meshes(module);
  vfc_python::bind_simplification(module);
  vfc_python::bind_untangling(module);
  vfc_python::bind_verification(module);
}
