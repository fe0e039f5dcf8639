// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_SIGNATURES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_SIGNATURES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/parameters/named_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Simplification_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Named parameters of the public functions: in space or inside a domain or mesh, of a network or of
// polylines. Parameters that set no member are documented here or at their first use, in the form
// of CGAL's manual, see named_parameters.py.

// \cgalParamNBegin{visitor}
//   \cgalParamDescription{receives the progress of the run, and can end it}
//   \cgalParamType{a model of `CurveFlowVisitor`, or `std::ref()` of one}
//   \cgalParamDefault{`Default_curve_flow_visitor()`}
// \cgalParamNEnd
using Visitor_tag = Tag_list<internal_np::visitor_t>;

// \cgalParamNBegin{origins}
//   \cgalParamDescription{receives the points of the input that the points of the result correspond
//     to, see `curve_origins()`; pass `std::ref()` of it}
//   \cgalParamType{for a polyline `std::vector<Curve_origin>`, for a container of polylines a
//     `std::vector` of these}
// \cgalParamDefault{none}
// \cgalParamNEnd
using Polyline_tags =
    Tag_list<internal_np::point_map_t, internal_np::closure_t, internal_np::origins_t>;

using Mesh_tags = Tag_list<internal_np::vertex_point_map_t, internal_np::check_mesh_t>;

using No_wall = Without<internal_np::wall_t>; // for functions without a domain

using Untangle_signature = Signature<Untangling_parameters, No_wall, Visitor_tag>;
using Untangle_polylines_signature =
    Signature<Untangling_parameters, No_wall, Visitor_tag, Polyline_tags>;

using Untangle_in_domain_signature = Signature<Untangling_parameters, Visitor_tag>;
using Untangle_polylines_in_domain_signature =
    Signature<Untangling_parameters, Visitor_tag, Polyline_tags>;

using Untangle_in_mesh_signature = Signature<Untangling_parameters, Visitor_tag, Mesh_tags>;
using Untangle_polylines_in_mesh_signature =
    Signature<Untangling_parameters, Visitor_tag, Mesh_tags, Polyline_tags>;

template <typename Point_3>
using Fill_signature = Signature<Filling_parameters<Point_3>, Visitor_tag>;
template <typename Point_3>
using Fill_polylines_signature = Signature<Filling_parameters<Point_3>, Visitor_tag, Polyline_tags>;

template <typename Point_3>
using Fill_mesh_signature = Signature<Filling_parameters<Point_3>, Visitor_tag, Mesh_tags>;
template <typename Point_3>
using Fill_mesh_with_polylines_signature =
    Signature<Filling_parameters<Point_3>, Visitor_tag, Mesh_tags, Polyline_tags>;

template <typename Point_3>
using Finger_signature = Signature<Finger_parameters<Point_3>>;

using Simplify_signature = Signature<Simplification_parameters>;
using Simplify_polylines_signature = Signature<Simplification_parameters, Polyline_tags>;

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_SIGNATURES_H
