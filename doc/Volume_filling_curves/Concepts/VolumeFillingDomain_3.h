// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

/*!
 * \ingroup PkgVolumeFillingCurvesConcepts
 * \cgalConcept
 *
 * The concept `VolumeFillingDomain_3` describes the set that a curve fills and never leaves.
 *
 * Three members decide: `is_inside()` accepts the start of a curve, and `is_triangle_inside()` each
 * elementary move, unless `distance()` shows that the triangle is far from the boundary. A curve
 * that starts inside, and whose moves only sweep triangles inside, stays inside. This is as certain
 * as the three answers: a model documents for which data they are exact, answers `false` in case of
 * doubt, and never returns a distance that exceeds the true one by more than rounding, which the
 * guard subtracts: 1e-9 of the diagonal of the box, or four units in the last place of its largest
 * coordinate if that is more. `distance_along()` only steers the curve and places the necks of
 * ports.
 *
 * The members can be called concurrently.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Volume_filling_curves::Triangle_mesh_domain_3}
 * \cgalHasModels{CGAL::Volume_filling_curves::Implicit_domain_3}
 * \cgalHasModels{CGAL::Volume_filling_curves::Ball_domain_3}
 * \cgalHasModels{CGAL::Volume_filling_curves::Box_domain_3}
 * \cgalHasModels{CGAL::Volume_filling_curves::Polygon_domain_3}
 * \cgalHasModels{CGAL::Volume_filling_curves::Inset_domain_3}
 * \cgalHasModels{CGAL::Volume_filling_curves::Unbounded_domain_3}
 * \cgalHasModelsEnd
 *
 * \sa `ScalableVolumeFillingDomain_3`
 * \sa `VolumeFillingDomainWithSurface_3`
 * \sa `PlanarVolumeFillingDomain_3`
 * \sa `CurveFlowTraits_3`
 */
class VolumeFillingDomain_3
{
public:
  /// \name Types
  /// @{

  /// The point type of the curve, that is, `CurveFlowTraits_3::Point_3` of its traits,
  /// constructible from three coordinates of type `double`.
  typedef unspecified_type Point_3;

  /// A type of vectors, constructible from three coordinates of type `double`, for example that of
  /// the kernel, or `CurveFlowTraits_3::Vector_3`.
  typedef unspecified_type Vector_3;

  /// @}

  /// \name Containment
  /// @{

  /// returns a box that contains the domain, with infinite bounds where it is unbounded.
  CGAL::Bbox_3 bbox() const;

  /// returns whether `p` lies strictly inside, not on the boundary.
  bool is_inside(const Point_3& p) const;

  /*!
   * returns whether the closed triangle `pqr` lies strictly inside. The triangle may be a segment
   * or a point.
   *
   * \pre `is_inside(p)`
   */
  bool is_triangle_inside(const Point_3& p, const Point_3& q, const Point_3& r) const;

  /// @}

  /// \name Distances
  /// @{

  /// returns a lower bound of the distance from `p` to the boundary, in the input's unit; it may be
  /// 0 if `p` is not inside.
  double distance(const Point_3& p) const;

  /// returns a lower bound of the distance from `p` to the boundary along the unit vector
  /// `direction`, at most `limit`.
  ///
  /// \pre `is_inside(p)`
  double distance_along(const Point_3& p, const Vector_3& direction, double limit) const;

  /// @}
};
