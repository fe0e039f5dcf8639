// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Named parameters fill the structs of parameters, and what a function does not take is an error at
// compile time: the trait that its static_assert uses is tested here.

#include "support/refusal_of.h"

#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/internal/parameters/named_parameters.h>
#include <CGAL/Volume_filling_curves/internal/parameters/signatures.h>
#include <CGAL/Volume_filling_curves/internal/state/Run_state.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

namespace test_named_parameters {

using namespace CGAL::Volume_filling_curves;
using CGAL::parameters::Default_named_parameters;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using internal::get_parameters;
using Untangle = internal::Untangle_signature;
using Untangle_polylines = internal::Untangle_polylines_signature;
using Fill = internal::Fill_signature<Point>;
using Simplify = internal::Simplify_signature;

Isotopy_certificate certificate;
const Run_state state;

void note(const Run_checkpoint&) {}

bool go_on(const Run_progress&)
{
  return true;
}

double one(const Point&)
{
  return 1;
}

// whether a function with a signature takes a sequence of named parameters
template <typename Signature, typename NamedParameters>
constexpr bool does_take()
{
  if constexpr(std::is_same_v<NamedParameters, CGAL::internal_np::No_property>)
    return true;
  else {
    using First = decltype(internal::as_sequence(std::declval<NamedParameters>()));
    return internal::does_know<Signature, typename First::Tag>() &&
           internal::does_take_value<Signature, typename First::Tag, typename First::Given>() &&
           does_take<Signature, typename First::Rest>();
  }
}

template <typename Signature, typename NamedParameters>
constexpr bool takes = does_take<Signature, NamedParameters>();

using Nothing = Default_named_parameters;
static_assert(takes<Untangle, Nothing> && takes<Fill, Nothing> && takes<Simplify, Nothing>);

// of the flow, of a run, and of one function
using Spacing = decltype(parameters::spacing(1));
static_assert(takes<Untangle, Spacing> && takes<Fill, Spacing> && !takes<Simplify, Spacing>);
using Seed = decltype(parameters::random_seed(1u));
static_assert(takes<Untangle, Seed> && takes<Fill, Seed> && !takes<Simplify, Seed>);
using Tolerance = decltype(parameters::tolerance(1));
static_assert(takes<Untangle, Tolerance> && !takes<Fill, Tolerance> && !takes<Simplify, Tolerance>);
using Length = decltype(parameters::length(1));
static_assert(!takes<Untangle, Length> && takes<Fill, Length> && !takes<Simplify, Length>);
using Clearance = decltype(parameters::clearance(1));
static_assert(!takes<Untangle, Clearance> && !takes<Fill, Clearance> && takes<Simplify, Clearance>);

// a wall without a domain, a map of points without points, a visitor without a flow
using Wall_parameter = decltype(parameters::wall(Wall::COVER));
static_assert(!takes<Untangle, Wall_parameter> && takes<Fill, Wall_parameter>);
using Point_map = decltype(parameters::point_map(1));
static_assert(takes<Untangle_polylines, Point_map> && !takes<Untangle, Point_map>);
using Visitor = decltype(parameters::visitor(Default_curve_flow_visitor()));
static_assert(takes<Untangle, Visitor> && takes<Fill, Visitor> && !takes<Simplify, Visitor>);

// anywhere in a chain, and names of CGAL that mean nothing here
using First = decltype(parameters::clearance(1).spacing(1).visitor(1));
using Last = decltype(parameters::visitor(1).spacing(1).clearance(1));
static_assert(!takes<Untangle, First> && !takes<Untangle, Last>);
using Verbose = decltype(CGAL::parameters::verbose(true));
static_assert(!takes<Untangle, Verbose> && !takes<Fill, Verbose> && !takes<Simplify, Verbose>);
using Of_cgal = decltype(CGAL::parameters::number_of_iterations(3).random_seed(1));
static_assert(takes<Untangle, Of_cgal> && takes<Fill, Of_cgal>);
using Combined =
    decltype(parameters::combine(CGAL::parameters::random_seed(1), parameters::length(2)));
static_assert(!takes<Untangle, Combined> && takes<Fill, Combined>);

// values of the right types
using Function = decltype(parameters::thickness(one));
static_assert(!takes<Untangle, Function> && takes<Fill, Function>);
static_assert(takes<Fill, decltype(parameters::thickness(std::function<double(const Point&)>()))>);
static_assert(!takes<Untangle, decltype(parameters::strategy(1))>);
static_assert(!takes<Untangle, decltype(parameters::tolerance("small"))>);
static_assert(!takes<Untangle, decltype(parameters::number_of_chains(1.5))>);
using Open = decltype(parameters::closure(Closure::OPEN));
static_assert(!takes<Untangle, Open> && takes<Untangle_polylines, Open>);
static_assert(!takes<Untangle_polylines, decltype(parameters::closure(true))>);
static_assert(takes<Untangle, decltype(parameters::certificate(std::ref(certificate)))>);
static_assert(takes<Untangle, decltype(parameters::certificate(&certificate))>);
static_assert(!takes<Untangle, decltype(parameters::certificate(certificate))>);
static_assert(takes<Fill, decltype(parameters::resume_from(std::cref(state)))>);
static_assert(!takes<Fill, decltype(parameters::resume_from(state))>);
static_assert(takes<Untangle, decltype(parameters::checkpoint(note))>);
static_assert(!takes<Simplify, decltype(parameters::checkpoint(note))>);
static_assert(takes<Untangle, decltype(parameters::progress(go_on))>);
static_assert(!takes<Untangle, decltype(parameters::progress(note))>);
static_assert(!takes<Untangle, decltype(parameters::checkpoint(one))>);

TEST(Named_parameters, fill_a_struct)
{
  const auto p = get_parameters<Untangle>(parameters::thickness(2)
                                              .number_of_iterations(3)
                                              .strategy(Untangling_strategy::FLOW)
                                              .certificate(std::ref(certificate))
                                              .build_name("1a2b3c4")
                                              .keep_length(true));
  EXPECT_EQ(p.thickness, 2);
  EXPECT_EQ(p.number_of_iterations, 3u);
  EXPECT_EQ(p.build_name, "1a2b3c4");
  EXPECT_EQ(p.strategy, Untangling_strategy::FLOW);
  EXPECT_EQ(p.certificate, &certificate);
  EXPECT_TRUE(p.keep_length);
}

TEST(Named_parameters, follow_those_of_cgal)
{
  const auto of_cgal = CGAL::parameters::number_of_iterations(3).random_seed(4);
  const auto p = get_parameters<Untangle>(
      parameters::combine(of_cgal, parameters::thickness(2).certificate(std::ref(certificate)))
          .keep_length(true));
  EXPECT_EQ(p.number_of_iterations, 3u);
  EXPECT_EQ(p.random_seed, 4u);
  EXPECT_EQ(p.thickness, 2);
  EXPECT_EQ(p.certificate, &certificate);
  EXPECT_TRUE(p.keep_length);
}

TEST(Named_parameters, leave_the_defaults_of_the_struct)
{
  EXPECT_EQ(get_parameters<Fill>(parameters::length(3)).max_radius,
            Filling_parameters<>().max_radius);
  EXPECT_EQ(get_parameters<Untangle>(Default_named_parameters()).tolerance,
            Untangling_parameters().tolerance);
}

TEST(Named_parameters, tell_a_thickness_from_a_function)
{
  EXPECT_FALSE(get_parameters<Fill>(parameters::thickness(3)).thickness_field);
  const auto p = get_parameters<Fill>(parameters::thickness(one));
  EXPECT_EQ(p.thickness, 0);
  EXPECT_EQ(p.thickness_field(Point(0, 0, 0)), 1);
}

template <typename Signature = Untangle, typename NamedParameters>
std::string complaint_about(const NamedParameters& np)
{
  return refusal_of([&] { internal::check_parameters(get_parameters<Signature>(np)); });
}

TEST(Checks, name_the_parameter_and_what_is_wrong)
{
  EXPECT_EQ(complaint_about(parameters::screening(-1)),
            "screening is -1, but must be positive and finite");
  EXPECT_EQ(complaint_about(parameters::coupling(-0.5)),
            "coupling is -0.5, but must be finite and not negative");
  EXPECT_EQ(complaint_about(parameters::time_limit(-1)),
            "time_limit is -1, but must not be negative");
  EXPECT_EQ(complaint_about(parameters::number_of_iterations(-1)),
            "number_of_iterations is -1, but must not be negative");
  EXPECT_EQ(complaint_about(parameters::number_of_chains(0)),
            "number_of_chains is 0, but must be positive and at most 1000000");
  EXPECT_EQ(complaint_about(parameters::number_of_directions(1000001)),
            "number_of_directions is 1000001, but must be positive and at most 1000000");
}

TEST(Checks, refuse_what_is_no_number_or_infinite)
{
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for(double x : {nan, infinity, -infinity}) {
    EXPECT_NE(complaint_about(parameters::thickness(x)), "");
    EXPECT_NE(complaint_about(parameters::spacing(x)), "");
    EXPECT_NE(complaint_about(parameters::max_displacement(x)), "");
    EXPECT_NE(complaint_about(parameters::tolerance(x)), "");
    EXPECT_NE(complaint_about<Fill>(parameters::length(x)), "");
    EXPECT_NE(complaint_about<Simplify>(parameters::clearance(x)), "");
  }
  EXPECT_NE(complaint_about(parameters::time_limit(nan)), "");
  EXPECT_NE(complaint_about<Simplify>(parameters::max_distance(nan)), "");
}

TEST(Checks, accept_the_ends_of_the_ranges)
{
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(complaint_about(Default_named_parameters()), "");
  EXPECT_EQ(complaint_about<Fill>(Default_named_parameters()), "");
  EXPECT_EQ(complaint_about<Simplify>(Default_named_parameters()), "");
  EXPECT_EQ(complaint_about(parameters::thickness(0).coupling(0).time_step(0).time_limit(0)), "");
  EXPECT_EQ(complaint_about(parameters::time_limit(infinity).number_of_iterations(0)), "");
  EXPECT_EQ(complaint_about<Simplify>(parameters::max_distance(infinity).clearance(0)), "");
}

TEST(Checks, compare_a_thickness_with_what_has_it)
{
  EXPECT_EQ(refusal_of([] { internal::check_thickness(1, 1, "the curves"); }), "");
  EXPECT_EQ(refusal_of([] { internal::check_thickness(1e300, 2, "the curves"); }),
            "thickness is 1e+300, but must not be larger than the curves, whose box has a diagonal "
            "of 2");
}

} // namespace test_named_parameters
