// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

/*!
 * \ingroup PkgVolumeFillingCurvesConcepts
 * \cgalConcept
 *
 * The concept `VolumeFillingDomainWithSurface_3` describes a domain whose boundary is a searchable
 * surface, such as a mesh, or a searchable curve in the plane: `distance()` returns distances, up
 * to rounding, instead of lower bounds, queries are answered in batches, and connected parts are
 * known exactly. This makes `CGAL::Volume_filling_curves::fill()` faster.
 *
 * The members are used only if all of them exist. They can be called concurrently.
 *
 * \cgalRefines{ScalableVolumeFillingDomain_3}
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Volume_filling_curves::Triangle_mesh_domain_3}
 * \cgalHasModels{CGAL::Volume_filling_curves::Polygon_domain_3}
 * \cgalHasModelsEnd
 */
class VolumeFillingDomainWithSurface_3
{
public:
  /// \name Distances
  /// @{

  /// returns the distance from `p` to the boundary, at most `limit`; the search may stop there.
  ///
  /// \pre `is_inside(p)`
  double distance_up_to(const Point_3& p, double limit) const;

  /*!
   * shortens rays from a point inside, whose directions lie in a plane, to their first
   * intersections with the boundary, as `distance_along()` does for each of them.
   *
   * \tparam Rays the class of the rays. Its members `source`, the point, and `normal`, a unit
   * vector orthogonal to the plane, have member functions `x()`, `y()` and `z()` that return a
   * `double`. Its members `x`, `y` and `z`, the coordinates of the unit vectors along the rays, and
   * `lengths`, the lengths of the rays, are of type `std::vector<double>` with an entry per ray.
   * Rays of length 0 are ignored.
   *
   * \param rays the rays, whose `lengths` are changed
   */
  template <typename Rays>
  void shorten(Rays& rays) const;

  /// @}

  /// \name Connected Parts
  /// @{

  /// returns the number of the connected part of the inside that contains `p`. Points of different
  /// parts have different numbers; some numbers may belong to no part.
  ///
  /// \pre `is_inside(p)`
  std::size_t part(const Point_3& p) const;

  /// returns a box for each number that `part()` may return, in the order of the numbers; the part
  /// with that number lies in the box.
  const std::vector<CGAL::Bbox_3>& part_boxes() const;

  /// @}
};
