// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_PARAMETER_TABLES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_PARAMETER_TABLES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/vocabulary/Chain_identity.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_run_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Simplification_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <functional>
#include <tuple>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Tables of parameters, the basis of reading, checking and refusing them. The table of a struct has
// a row per member: the named parameter that sets it, and the range of its values. Rows have the
// names of the members. A new parameter takes a documented member of a struct, a name in
// vocabulary/parameters.h, and a row here.

enum class Range
{
  ANY,
  POSITIVE,             // and finite
  UP_TO_ONE,            // and positive
  UP_TO_A_MILLION,      // likewise
  NOT_NEGATIVE,         // and finite
  NOT_NEGATIVE_OR_NEVER // or infinite
};

template <typename Tag_, typename Struct, typename Value_>
struct Parameter
{
  using Tag = Tag_;
  using Value = Value_;

  Value Struct::*member;
  Range range;
};

template <typename Tag, typename Struct, typename Value>
constexpr Parameter<Tag, Struct, Value> parameter(Value Struct::*member, Range range = Range::ANY)
{
  return {member, range};
}

// Table of a struct, selected by the type of the argument.
constexpr auto parameter_table(const Curve_flow_parameters*)
{
  using namespace internal_np;
  using P = Curve_flow_parameters;
  return std::make_tuple(
      parameter<thickness_t>(&P::thickness, Range::NOT_NEGATIVE),
      parameter<number_of_directions_t>(&P::number_of_directions, Range::UP_TO_A_MILLION),
      parameter<max_radius_t>(&P::max_radius, Range::POSITIVE),
      parameter<spacing_t>(&P::spacing, Range::UP_TO_ONE),
      parameter<screening_t>(&P::screening, Range::POSITIVE),
      parameter<medial_weight_t>(&P::medial_weight, Range::POSITIVE),
      parameter<coupling_t>(&P::coupling, Range::NOT_NEGATIVE),
      parameter<preconditioner_t>(&P::preconditioner), parameter<wall_t>(&P::wall),
      parameter<max_displacement_t>(&P::max_displacement, Range::POSITIVE),
      parameter<time_step_t>(&P::time_step, Range::NOT_NEGATIVE));
}

constexpr auto parameter_table(const Curve_run_parameters* p)
{
  using namespace internal_np;
  using P = Curve_run_parameters;
  return std::tuple_cat(
      parameter_table(static_cast<const Curve_flow_parameters*>(p)),
      std::make_tuple(
          parameter<number_of_iterations_t>(&P::number_of_iterations),
          parameter<time_limit_t>(&P::time_limit, Range::NOT_NEGATIVE_OR_NEVER),
          parameter<random_seed_t>(&P::random_seed), parameter<certificate_t>(&P::certificate),
          parameter<progress_t>(&P::progress), parameter<checkpoint_t>(&P::checkpoint),
          parameter<resume_from_t>(&P::resume_from), parameter<build_name_t>(&P::build_name)));
}

constexpr auto parameter_table(const Untangling_parameters* p)
{
  using namespace internal_np;
  using P = Untangling_parameters;
  return std::tuple_cat(
      parameter_table(static_cast<const Curve_run_parameters*>(p)),
      std::make_tuple(parameter<strategy_t>(&P::strategy),
                      parameter<number_of_chains_t>(&P::number_of_chains, Range::UP_TO_A_MILLION),
                      parameter<tolerance_t>(&P::tolerance, Range::NOT_NEGATIVE),
                      parameter<stop_at_proof_t>(&P::stop_at_proof),
                      parameter<lower_ropelength_t>(&P::lower_ropelength),
                      parameter<keep_length_t>(&P::keep_length),
                      parameter<bend_radius_t>(&P::bend_radius, Range::NOT_NEGATIVE),
                      parameter<strand_distance_t>(&P::strand_distance, Range::NOT_NEGATIVE)));
}

// Table of Filling_parameters. The thickness has two rows: a number and a function.
template <typename Point_3>
constexpr auto parameter_table(const Filling_parameters<Point_3>* p)
{
  using namespace internal_np;
  using P = Filling_parameters<Point_3>;
  return std::tuple_cat(
      parameter_table(static_cast<const Curve_run_parameters*>(p)),
      std::make_tuple(parameter<thickness_t>(&P::thickness_field),
                      parameter<direction_field_t>(&P::direction_field),
                      parameter<direction_weight_t>(&P::direction_weight, Range::NOT_NEGATIVE),
                      parameter<length_t>(&P::length, Range::NOT_NEGATIVE),
                      parameter<wall_distance_t>(&P::wall_distance, Range::NOT_NEGATIVE),
                      parameter<ports_t>(&P::ports), parameter<volume_shares_t>(&P::volume_shares),
                      parameter<start_t>(&P::start),
                      parameter<bend_radius_t>(&P::bend_radius, Range::NOT_NEGATIVE),
                      parameter<strand_distance_t>(&P::strand_distance, Range::NOT_NEGATIVE),
                      parameter<round_bends_t>(&P::round_bends)));
}

template <typename Point_3>
constexpr auto parameter_table(const Finger_parameters<Point_3>*)
{
  using namespace internal_np;
  using P = Finger_parameters<Point_3>;
  return std::make_tuple(parameter<thickness_t>(&P::thickness, Range::NOT_NEGATIVE),
                         parameter<thickness_t>(&P::thickness_field),
                         parameter<direction_field_t>(&P::direction_field),
                         parameter<direction_weight_t>(&P::direction_weight, Range::NOT_NEGATIVE),
                         parameter<random_seed_t>(&P::random_seed),
                         parameter<time_limit_t>(&P::time_limit, Range::NOT_NEGATIVE_OR_NEVER),
                         parameter<progress_t>(&P::progress));
}

constexpr auto parameter_table(const Simplification_parameters*)
{
  using namespace internal_np;
  using P = Simplification_parameters;
  return std::make_tuple(parameter<max_distance_t>(&P::max_distance, Range::NOT_NEGATIVE_OR_NEVER),
                         parameter<clearance_t>(&P::clearance, Range::NOT_NEGATIVE),
                         parameter<certificate_t>(&P::certificate),
                         parameter<progress_t>(&P::progress));
}

constexpr auto parameter_table(const Chain_parameters*)
{
  using namespace internal_np;
  using P = Chain_parameters;
  return std::make_tuple(parameter<closures_t>(&P::closures, Range::UP_TO_A_MILLION),
                         parameter<random_seed_t>(&P::random_seed),
                         parameter<find_core_t>(&P::find_core), parameter<stride_t>(&P::stride),
                         parameter<progress_t>(&P::progress));
}

// Parameters of functions without a status, see watched().
struct Progress_parameters
{
  /// Is called with a `Run_progress` every few milliseconds, like `Curve_run_parameters::progress`.
  /// If it returns `false`, `Run_interrupted` is thrown.
  std::function<bool(const Run_progress&)> progress;
};

constexpr auto parameter_table(const Progress_parameters*)
{
  return std::make_tuple(parameter<internal_np::progress_t>(&Progress_parameters::progress));
}

template <typename Parameters>
constexpr auto parameter_table()
{
  return parameter_table(static_cast<const Parameters*>(nullptr));
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_PARAMETER_TABLES_H
