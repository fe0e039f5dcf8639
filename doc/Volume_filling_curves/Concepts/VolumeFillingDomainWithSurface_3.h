// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

/*!
 * \ingroup PkgVolumeFillingCurvesConcepts
 * \cgalConcept
 *
 * The concept `VolumeFillingDomainWithSurface_3` describes a domain whose boundary is a surface
 * that can be searched, such as a mesh: `distance()` returns distances instead of lower bounds, and
 * questions that any domain is asked one by one are answered together. That changes how long
 * `CGAL::Volume_filling_curves::fill()` takes, and finds connected parts exactly.
 *
 * The members are used if all of them are there. Calling them concurrently is safe.
 *
 * \cgalRefines{ScalableVolumeFillingDomain_3}
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Volume_filling_curves::Triangle_mesh_domain_3}
 * \cgalHasModelsEnd
 */
class VolumeFillingDomainWithSurface_3
{
public:
  /// \name Distances
  /// @{

  /// returns the distance of `p` to the boundary, or `limit` if that is less, at which the search
  /// may end.
  ///
  /// \pre `is_inside(p)`
  double distance_up_to(const Point_3& p, double limit) const;

  /*!
   * shortens rays from a point inside, in directions of a plane, to where they first meet the
   * boundary: `distance_along()` for each of them.
   *
   * \tparam Rays the class of the rays, with the members `source`, the point, and `normal`, a unit
   * vector orthogonal to the plane, each with member functions `x()`, `y()` and `z()` that return a
   * `double`; and with the members `x`, `y` and `z`, the coordinates of the unit vectors along the
   * rays, and `lengths`, their lengths, all of type `std::vector<double>` with an entry per ray. A
   * ray of length 0 does not matter.
   *
   * \param rays the rays, whose `lengths` are changed
   */
  template <typename Rays>
  void shorten(Rays& rays) const;

  /// @}

  /// \name Connected Parts
  /// @{

  /// returns the number of the connected part of the inside that `p` lies in. Points of different
  /// parts have different numbers; not every number is that of a part.
  ///
  /// \pre `is_inside(p)`
  std::size_t part(const Point_3& p) const;

  /// returns a box for each number that `part()` may return, in the order of the numbers; a part
  /// lies in the box of its number.
  const std::vector<CGAL::Bbox_3>& part_boxes() const;

  /// @}
};
