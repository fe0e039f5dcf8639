// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The list of the package's named parameters, to be included with the macro
// CGAL_VFC_PARAMETER(name) defined; as in CGAL's file of the same name there is no guard.

CGAL_VFC_PARAMETER(thickness)
CGAL_VFC_PARAMETER(number_of_directions)
CGAL_VFC_PARAMETER(max_radius)
CGAL_VFC_PARAMETER(spacing)
CGAL_VFC_PARAMETER(screening)
CGAL_VFC_PARAMETER(coupling)
CGAL_VFC_PARAMETER(preconditioner)
CGAL_VFC_PARAMETER(time_step)
CGAL_VFC_PARAMETER(tolerance)
CGAL_VFC_PARAMETER(time_limit)
CGAL_VFC_PARAMETER(stop_at_proof)
CGAL_VFC_PARAMETER(keep_length)
CGAL_VFC_PARAMETER(certificate)
CGAL_VFC_PARAMETER(max_distance)
CGAL_VFC_PARAMETER(clearance)
CGAL_VFC_PARAMETER(strategy)
CGAL_VFC_PARAMETER(number_of_chains)
CGAL_VFC_PARAMETER(length)
CGAL_VFC_PARAMETER(wall)
