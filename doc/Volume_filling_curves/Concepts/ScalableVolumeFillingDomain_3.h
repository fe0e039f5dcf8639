// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

/*!
 * \ingroup PkgVolumeFillingCurvesConcepts
 * \cgalConcept
 *
 * The concept `ScalableVolumeFillingDomain_3` describes a domain that
 * `CGAL::Volume_filling_curves::fill()` can scale by a power of two, to a unit of length in which
 * nothing overflows. Domains with a coordinate beyond 1e38, or with all coordinates below 1e-38,
 * must be models of this concept.
 *
 * \cgalRefines{VolumeFillingDomain_3}
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Volume_filling_curves::Triangle_mesh_domain_3}
 * \cgalHasModels{CGAL::Volume_filling_curves::Implicit_domain_3}
 * \cgalHasModels{CGAL::Volume_filling_curves::Ball_domain_3}
 * \cgalHasModels{CGAL::Volume_filling_curves::Box_domain_3}
 * \cgalHasModels{CGAL::Volume_filling_curves::Polygon_domain_3}
 * \cgalHasModels{CGAL::Volume_filling_curves::Inset_domain_3}
 * \cgalHasModelsEnd
 */
class ScalableVolumeFillingDomain_3
{
public:
  /// returns the domain, of the same type, with all coordinates multiplied by `factor`, a power of
  /// two.
  ScalableVolumeFillingDomain_3 scaled(double factor) const;
};
