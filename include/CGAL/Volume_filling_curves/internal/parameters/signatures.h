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

// The named parameters that the public functions take.

// There is no domain, hence no wall.
using Untangle_signature = Signature<Untangling_parameters,
                                     Tag_list<internal_np::visitor_t>,
                                     Tag_list<internal_np::wall_t>>;

using Untangle_in_domain_signature =
    Signature<Untangling_parameters, Tag_list<internal_np::visitor_t>>;

using Untangle_in_mesh_signature = Signature<
    Untangling_parameters,
    Tag_list<internal_np::visitor_t, internal_np::vertex_point_map_t, internal_np::check_mesh_t>>;

using Untangle_polylines_signature = Signature<Untangling_parameters,
                                               Tag_list<internal_np::visitor_t,
                                                        internal_np::point_map_t,
                                                        internal_np::closure_t,
                                                        internal_np::origins_t>,
                                               Tag_list<internal_np::wall_t>>;

using Untangle_polylines_in_domain_signature = Signature<Untangling_parameters,
                                                         Tag_list<internal_np::visitor_t,
                                                                  internal_np::point_map_t,
                                                                  internal_np::closure_t,
                                                                  internal_np::origins_t>>;

using Untangle_polylines_in_mesh_signature = Signature<Untangling_parameters,
                                                       Tag_list<internal_np::visitor_t,
                                                                internal_np::vertex_point_map_t,
                                                                internal_np::check_mesh_t,
                                                                internal_np::point_map_t,
                                                                internal_np::closure_t,
                                                                internal_np::origins_t>>;

template <typename Point_3>
using Fill_signature = Signature<Filling_parameters<Point_3>, Tag_list<internal_np::visitor_t>>;

template <typename Point_3>
using Fill_polylines_signature = Signature<Filling_parameters<Point_3>,
                                           Tag_list<internal_np::visitor_t,
                                                    internal_np::point_map_t,
                                                    internal_np::closure_t,
                                                    internal_np::origins_t>>;

template <typename Point_3>
using Fill_mesh_with_polylines_signature = Signature<Filling_parameters<Point_3>,
                                                     Tag_list<internal_np::visitor_t,
                                                              internal_np::vertex_point_map_t,
                                                              internal_np::check_mesh_t,
                                                              internal_np::point_map_t,
                                                              internal_np::closure_t,
                                                              internal_np::origins_t>>;

template <typename Point_3>
using Fill_mesh_signature = Signature<
    Filling_parameters<Point_3>,
    Tag_list<internal_np::visitor_t, internal_np::vertex_point_map_t, internal_np::check_mesh_t>>;

template <typename Point_3>
using Finger_signature = Signature<Finger_parameters<Point_3>>;

using Simplify_signature = Signature<Simplification_parameters>;

using Simplify_polylines_signature =
    Signature<Simplification_parameters,
              Tag_list<internal_np::point_map_t, internal_np::closure_t, internal_np::origins_t>>;

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_SIGNATURES_H
