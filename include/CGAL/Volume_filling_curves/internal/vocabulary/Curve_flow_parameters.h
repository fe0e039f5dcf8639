// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CURVE_FLOW_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CURVE_FLOW_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstddef>
#include <ostream>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
///
/// The matrix that maps the gradient of the energy to the direction of a step. `L` is the Laplacian
/// of the curve, `M` the diagonal matrix of the nodes' shares of the length, and R the radius of a
/// medial sphere; alpha, beta and lambda are `medial_weight`, `coupling` and `screening` of the
/// `Curve_flow_parameters`.
enum class Preconditioner
{
  MEDIAL,       ///< `L`, coupled with weight beta / R along medial spheres, + lambda `M`
  H1,           ///< `L` + lambda `M`
  L2,           ///< lambda `M`
  QUASI_NEWTON, ///< `L` + alpha `M`, the Hessian with the spheres held fixed
  CONTACT       ///< `L` + lambda `M` + the stiffness of contacts between strands at the same sphere
};

/// \ingroup PkgVolumeFillingCurvesRef
///
/// returns the name in plain English, for example "quasi-newton".
inline const char* to_string(Preconditioner preconditioner)
{
  switch(preconditioner) {
  case Preconditioner::MEDIAL:
    return "medial";
  case Preconditioner::H1:
    return "h1";
  case Preconditioner::L2:
    return "l2";
  case Preconditioner::QUASI_NEWTON:
    return "quasi-newton";
  case Preconditioner::CONTACT:
    return "contact";
  }
  return "";
}

/// \ingroup PkgVolumeFillingCurvesRef
///
/// writes the name in plain English.
inline std::ostream& operator<<(std::ostream& out, Preconditioner preconditioner)
{
  return out << to_string(preconditioner);
}

/// \ingroup PkgVolumeFillingCurvesRef
///
/// The way in which the boundary of a domain limits the medial spheres of a curve inside.
enum class Wall
{
  COVER,     ///< their centers stay inside: the curve settles at about r from the boundary
  KEEP_CLEAR ///< the whole spheres stay inside: the curve settles at about 2 r from the boundary
};

/// \ingroup PkgVolumeFillingCurvesRef
///
/// returns the name in plain English, for example "keep clear".
inline const char* to_string(Wall wall)
{
  switch(wall) {
  case Wall::COVER:
    return "cover";
  case Wall::KEEP_CLEAR:
    return "keep clear";
  }
  return "";
}

/// \ingroup PkgVolumeFillingCurvesRef
///
/// writes the name in plain English.
inline std::ostream& operator<<(std::ostream& out, Wall wall)
{
  return out << to_string(wall);
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/Curve_flow_3.h
 *
 * \brief The parameters of a `Curve_flow_3`.
 *
 * Only the thickness is a length; all others are in units of the thickness r or dimensionless:
 * scaling the input scales the output and changes nothing else.
 */
struct Curve_flow_parameters
{
  /// The thickness r, in the input's unit. Strands of a tight curve end about r apart; in a
  /// filling, most points end within r of the curve. 0 (default) stands for a thickness that suits
  /// the input: `default_thickness()` in `untangle()`, and see `Filling_parameters` for `fill()`.
  double thickness = 0;

  /// The number N of medial spheres per node; always 2 in a planar domain.
  std::size_t number_of_directions = 16;

  /// The largest radius of a medial sphere, in units of r. Below 1 the curve shrinks where it can.
  double max_radius = 0.9;

  /// The least length of an edge, in units of r, at most 1: with longer edges a curve cannot bend
  /// enough. Edges longer than twice this length are split. `untangle()` uses longer edges until
  /// the last stage. `fill()` uses edges of at least 0.3 r once fingers have opened, or from the
  /// start if it starts from circles: until the last stage, or with `round_bends` to the end.
  double spacing = 0.2;

  /// The weight lambda of `M` in the preconditioner, in units of 1 / r^2: the locality of the flow.
  double screening = 0.3;

  /// The weight alpha of the medial spheres in the energy, in units of 1 / r^2. With 3.36^2, the
  /// value of the paper (section 3.3), the mean medial radius of a curve that fills a domain
  /// reaches r while the curve grows, and settles at 0.93 r. Half of it counts in a planar domain.
  double medial_weight = 3.36 * 3.36;

  /// The weight beta of the coupling along medial spheres in the preconditioner, dimensionless;
  /// only `Preconditioner::MEDIAL` uses it.
  double coupling = 0.01;

  /// The preconditioner. The default of `untangle()` is `Preconditioner::CONTACT`.
  Preconditioner preconditioner = Preconditioner::MEDIAL;

  /// The way in which the boundary limits the medial spheres, if there is a domain.
  Wall wall = Wall::COVER;

  /// The largest displacement of a node in a step, in units of r. `untangle()` uses 2.5 times this
  /// value while edges are longer.
  double max_displacement = 0.5;

  /// The time step tau of the paper, dimensionless. 0 (default) stands for an adaptive step.
  double time_step = 0;
};

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/Curve_flow_3.h
///
/// The work of a `Curve_flow_3` so far.
struct Curve_flow_statistics
{
  std::size_t iterations = 0;        ///< number of steps
  std::size_t certified_changes = 0; ///< changes of a node that were certified and made
  std::size_t refused_changes = 0;   ///< changes of a node that were refused
  std::size_t shortened_steps = 0;   ///< steps that were shortened, or not made
  std::size_t refused_remeshing = 0; ///< collapses and splits that were refused
  double seconds_medial_spheres = 0; ///< time spent on medial spheres
  double seconds_direction = 0;      ///< time spent on the gradient and the preconditioner
  double seconds_motion = 0;         ///< time spent on certified motion
  double seconds_remeshing = 0;      ///< time spent on certified remeshing

  /// adds the work of another flow.
  Curve_flow_statistics& operator+=(const Curve_flow_statistics& other)
  {
    iterations += other.iterations;
    certified_changes += other.certified_changes;
    refused_changes += other.refused_changes;
    shortened_steps += other.shortened_steps;
    refused_remeshing += other.refused_remeshing;
    seconds_medial_spheres += other.seconds_medial_spheres;
    seconds_direction += other.seconds_direction;
    seconds_motion += other.seconds_motion;
    seconds_remeshing += other.seconds_remeshing;
    return *this;
  }
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CURVE_FLOW_PARAMETERS_H
