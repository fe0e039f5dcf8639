// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/repair_steps.h"

#include "options/numbers.h"

#include <CGAL/alpha_wrap_3.h>

#include <utility>

namespace vfc {

std::string wrap_faces(double alpha, Mesh& mesh)
{
  const double offset = alpha / 30;
  Mesh wrap;
  CGAL::alpha_wrap_3(mesh, alpha, offset, wrap);
  mesh = std::move(wrap);
  return "wrapped, since nothing milder helped: by a surface at a distance of " + to_text(offset) +
         ", which enters no gap narrower than " + to_text(alpha);
}

} // namespace vfc
