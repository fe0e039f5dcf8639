// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

/*!
 * \ingroup PkgVolumeFillingCurvesConcepts
 * \cgalConcept
 *
 * The concept `CurveFlowTraits_3` describes the point type of a curve and the predicates that
 * certify every change of the curve.
 *
 * The predicates must be exact for all points that `Construct_point_3` constructs from finite
 * coordinates of type `double`, including collinear, coplanar and coincident points. All
 * certificates rest on this: a traits class whose predicates round is not a model, even if it
 * compiles.
 *
 * Models are copyable and assignable. Default construction is required only where no traits object
 * is passed. Functors are copyable, and a functor and its copies can be called concurrently.
 *
 * Every kernel of \cgal is a model if its predicates are exact and its number type holds every
 * `double`.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Volume_filling_curves::Curve_flow_traits_3}
 * \cgalHasModels{\cgal's kernels with exact predicates and a number type that holds every `double`}
 * \cgalHasModelsEnd
 *
 * \sa `CGAL::Volume_filling_curves::Curve_network_3`
 * \sa `CGAL::Volume_filling_curves::Isotopy_guard_3`
 */
class CurveFlowTraits_3
{
public:
  /// \name Types
  /// @{

  /*!
   * The point type, a model of `CopyConstructible` and `CopyAssignable`.
   *
   * It has the member functions `x()`, `y()` and `z()`, whose values `CGAL::to_double()` converts
   * to `double`. For a point from `Construct_point_3` these are exactly its arguments. Neither a
   * default constructor nor comparisons are required.
   */
  typedef unspecified_type Point_3;

  /*!
   * A type of vectors, constructible from three coordinates of type `double`, with the member
   * functions `x()`, `y()` and `z()`, whose values `CGAL::to_double()` converts back. Domains
   * return distances along such vectors.
   */
  typedef unspecified_type Vector_3;

  /*!
   * A functor with <tt>%Point_3 operator()(double x, double y, double z) const</tt>, which returns
   * the point with exactly these coordinates.
   */
  typedef unspecified_type Construct_point_3;

  /*!
   * A predicate with <tt>%CGAL::Orientation operator()(Point_3 p, Point_3 q, Point_3 r, Point_3 s)
   * const</tt>, which returns the sign of the determinant of `q - p`, `r - p` and `s - p`:
   * `CGAL::COPLANAR` if and only if the four points lie in a plane.
   */
  typedef unspecified_type Orientation_3;

  /*!
   * A predicate with <tt>%CGAL::Orientation operator()(Point_3 p, Point_3 q, Point_3 r) const</tt>.
   *
   * Returns `CGAL::COLLINEAR` if and only if the three points lie on a line, and otherwise
   * `CGAL::POSITIVE` or `CGAL::NEGATIVE`, consistently for all triples of points in one plane: two
   * triples in a common plane get the same sign if and only if they turn in the same direction. The
   * positive direction may be chosen for each plane.
   */
  typedef unspecified_type Coplanar_orientation_3;

  /*!
   * A predicate with <tt>bool operator()(Point_3 p, Point_3 q) const</tt>, which returns whether
   * `p` comes before `q` in lexicographic order of the coordinates x, y and z. Points are equal if
   * neither comes before the other.
   */
  typedef unspecified_type Less_xyz_3;

  /// @}

  /// \name Operations
  /// @{

  /// returns the functor that constructs points.
  Construct_point_3 construct_point_3_object() const;

  /// returns the predicate for the orientation of four points.
  Orientation_3 orientation_3_object() const;

  /// returns the predicate for the orientation of three points in their plane.
  Coplanar_orientation_3 coplanar_orientation_3_object() const;

  /// returns the predicate that compares points lexicographically.
  Less_xyz_3 less_xyz_3_object() const;

  /// @}
};
