// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CHAIN_IDENTITY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CHAIN_IDENTITY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesKnots
 * \headerfile CGAL/Volume_filling_curves/identify.h
 *
 * \brief The parameters of `identify_chain()`.
 *
 * Each member can be set by the named parameter of the same name.
 */
struct Chain_parameters
{
  /// The number of directions in which the ends of the chain are extended. 100 by default.
  std::size_t closures = 100;

  /// The seed of the rotation that is applied to the lattice of directions. 0 by default.
  std::size_t random_seed = 0;

  /// Whether to look for the core of the knot. `false` by default.
  bool find_core = false;

  /// The number of edges between the nodes at which sections of the fingerprint begin and end. 0
  /// (default) for no fingerprint.
  std::size_t stride = 0;

  /// Is called with a `Run_progress` every few milliseconds, like
  /// `Curve_run_parameters::progress`. If it returns `false`, `Run_interrupted` is thrown.
  std::function<bool(const Run_progress&)> progress;
};

/// \ingroup PkgVolumeFillingCurvesKnots
/// \headerfile CGAL/Volume_filling_curves/identify.h
///
/// The knot of one closure of an open chain.
struct Closure_knot
{
  /// As `Link_identity::name`; empty for a knot without a name, or if the closure meets the chain.
  std::string name;

  /// Whether the name is a theorem, as `Link_identity::is_proved`.
  bool is_proved = false;
};

/// \ingroup PkgVolumeFillingCurvesKnots
/// \headerfile CGAL/Volume_filling_curves/identify.h
///
/// A knot among the closures of an open chain to infinity, in many directions.
struct Knot_share
{
  std::string name;          ///< as `Link_identity::name`; empty for all knots without a name
  bool is_proved = false;    ///< whether the name is a theorem for each of these closures
  std::size_t count = 0;     ///< closures that form this knot
  double share = 0;          ///< part of all closures, from 0 to 1
  double standard_error = 0; ///< of the share p of N directions: the square root of p (1 - p) / N
};

/// \ingroup PkgVolumeFillingCurvesKnots
/// \headerfile CGAL/Volume_filling_curves/identify.h
///
/// A section of an open chain, and the most frequent knot of its closures.
struct Chain_section
{
  std::size_t first = 0; ///< first node, counted along the chain from 0
  std::size_t last = 0;  ///< last node
  std::string name;      ///< as `Knot_share::name`
  double share = 0;      ///< as `Knot_share::share`
};

/// \ingroup PkgVolumeFillingCurvesKnots
/// \headerfile CGAL/Volume_filling_curves/identify.h
///
/// What `identify_chain()` finds out about an open chain.
struct Chain_identity
{
  /// The most frequent knot, as `Knot_share::name`.
  std::string name;

  /// The knots of all closures to infinity, from the most frequent one; equally frequent ones in
  /// the order of their names.
  std::vector<Knot_share> knots;

  /// The knot of the chain closed by the segment between its ends.
  Closure_knot direct;

  /// The knot of the minimally interfering closure: the ends are joined by a segment or, if that is
  /// shorter, each is extended to the nearest point of the convex hull, and beyond.
  Closure_knot least_interfering;

  /// The core of the knot, if it is sought: a section whose most frequent knot is that of the
  /// chain, while removing a node at either end changes this. One if the knot of the chain has
  /// a name and is not the unknot, else none.
  std::vector<Chain_section> core;

  /// The fingerprint, if it is wanted: all sections between nodes whose numbers are multiples of
  /// the stride, or the last node, in the order of their first nodes and then of their last ones.
  std::vector<Chain_section> fingerprint;

  /// The slipknots in the fingerprint: for each knot of more than half of the closures of a
  /// section that is neither the unknot nor the knot of the chain, a shortest section with it.
  std::vector<Chain_section> slipknots;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CHAIN_IDENTITY_H
