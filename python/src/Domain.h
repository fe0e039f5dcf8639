// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PYTHON_DOMAIN_H
#define VFC_PYTHON_DOMAIN_H

#include "arrays.h"

#include <CGAL/Volume_filling_curves/internal/domain/Any_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/Polygon_domain_3.h>

#include <memory>
#include <variant>

namespace vfc_python {

namespace internal = VFC::internal;

using Any_domain = internal::Any_domain_3<Point>;
using Planar_domain = VFC::Polygon_domain_3<Curve::Traits>;

// A domain as Python holds it.
struct Domain
{
  // one alternative per dimension, a compile-time property
  std::variant<Any_domain, Planar_domain> inside;
  std::shared_ptr<const Mesh> mesh; // that bounds it, for fields at its vertices; may be null
};

} // namespace vfc_python

#endif // VFC_PYTHON_DOMAIN_H
