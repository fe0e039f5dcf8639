// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

/*!
 * \ingroup PkgVolumeFillingCurvesConcepts
 * \cgalConcept
 *
 * The concept `PlanarVolumeFillingDomain_3` describes a domain in the plane z = 0. The inside is
 * open in the plane, and points off the plane are outside. Curves therefore stay in the plane:
 * every z coordinate is 0. `CGAL::Volume_filling_curves::fill()` considers areas instead of
 * volumes, also in its results.
 *
 * The boundary is that of the inside in the plane: `distance()` and `distance_along()` return
 * distances to it. They are only called with points and directions in the plane. The box is flat.
 *
 * \cgalRefines{VolumeFillingDomain_3}
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Volume_filling_curves::Polygon_domain_3}
 * \cgalHasModels{CGAL::Volume_filling_curves::Inset_domain_3}
 * \cgalHasModelsEnd
 */
class PlanarVolumeFillingDomain_3
{
public:
  /// the dimension of the domain
  static constexpr int dimension = 2;
};
