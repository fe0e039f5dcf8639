// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/fill_test_support.h"
#include "support/polygon_test_support.h"
#include "support/refusal_of.h"

#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/internal/domain/Polygon_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_state.h>
#include <CGAL/Volume_filling_curves/internal/state/Byte_archive.h>
#include <CGAL/Volume_filling_curves/internal/state/Run_saver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

// Functions, domains and states of users that make no sense: a message or a valid result, never a
// run without an end.
namespace test_fill_refusals {

using namespace fill_test;
namespace internal = VFC::internal;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A cube of side 2 whose answers can be replaced.
struct Strange_domain
{
  using Point_3 = Point;
  using Vector_3 = Kernel::Vector_3;

  VFC::Box_domain_3<> cube{Point(-1, -1, -1), Point(1, 1, 1)};
  std::function<CGAL::Bbox_3()> box = [this] { return cube.bbox(); };
  std::function<bool(const Point&)> inside = [this](const Point& p) { return cube.is_inside(p); };
  std::function<bool(const Point&, const Point&, const Point&)> triangle_inside =
      [this](const Point& p, const Point& q, const Point& r) {
        return cube.is_triangle_inside(p, q, r);
      };
  std::function<double(const Point&)> room = [this](const Point& p) { return cube.distance(p); };
  std::function<double(double)> along = [](double distance) { return distance; };

  CGAL::Bbox_3 bbox() const { return box(); }
  bool is_inside(const Point& p) const { return inside(p); }
  bool is_triangle_inside(const Point& p, const Point& q, const Point& r) const
  {
    return triangle_inside(p, q, r);
  }
  double distance(const Point& p) const { return room(p); }
  double distance_along(const Point& p, const Vector_3& direction, double limit) const
  {
    return along(cube.distance_along(p, direction, limit));
  }
};

// Fills and returns the message of the exception, or "" if the result is valid.
template <typename Domain, typename NamedParameters>
std::string refusal(const Domain& domain, const NamedParameters& np)
{
  Curve curve;
  try {
    VFC::fill(curve, domain, np.number_of_iterations(3));
  } catch(const std::invalid_argument& error) {
    return error.what();
  }
  EXPECT_TRUE(VFC::is_embedded(curve));
  return "";
}

template <typename Field>
std::string refusal_of_thickness(const Field& field)
{
  return refusal(Strange_domain(), VFC::parameters::thickness(field));
}

std::string refusal_of_domain(const Strange_domain& domain)
{
  return refusal(domain, VFC::parameters::thickness(.4));
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

// With nan, -0.1 and 0 in half of the domain, and everywhere.
TEST(Fill, tells_where_a_thickness_is_not_positive_and_finite)
{
  for(const double bad : {nan, -.1, 0., infinity})
    for(const double border : {-infinity, 0., infinity}) {
      const std::string message =
          refusal_of_thickness([&](const Point& p) { return p.x() > border ? .4 : bad; });
      if(border == -infinity) {
        EXPECT_EQ(message, "");
        continue;
      }
      EXPECT_TRUE(contains(message, "thickness is ")) << message;
      EXPECT_TRUE(contains(message, " at (")) << message;
      EXPECT_TRUE(contains(message, ", but must be positive and finite")) << message;
    }
  EXPECT_TRUE(
      contains(refusal_of_thickness([](const Point&) { return -.1; }), "thickness is -0.1 at ("));
  EXPECT_TRUE(contains(refusal_of_thickness([](const Point&) { return 1e9; }),
                       "must not be larger than the domain"));
}

TEST(Fill, ends_with_a_thickness_that_jumps_everywhere)
{
  const auto noise = [](const Point& p) {
    const double x = 1e6 * (p.x() + 3 * p.y() + 7 * p.z());
    return .2 + .4 * (x - std::floor(x));
  };
  EXPECT_EQ(refusal_of_thickness(noise), "");
}

TEST(Fill, passes_on_what_functions_throw)
{
  const auto fill_with = [](const auto& np, const Strange_domain& domain) {
    Curve curve;
    VFC::fill(curve, domain, np);
  };
  const auto field = [](const Point& p) { return p.x() > 0 ? throw std::logic_error("mine") : .4; };
  EXPECT_THROW(fill_with(VFC::parameters::thickness(field), Strange_domain()), std::logic_error);
  const auto directions = [](const Point&) -> std::array<double, 3> {
    throw std::logic_error("mine");
  };
  EXPECT_THROW(
      fill_with(VFC::parameters::thickness(.4).direction_field(directions), Strange_domain()),
      std::logic_error);
  Strange_domain domain;
  domain.room = [](const Point&) -> double { throw std::logic_error("mine"); };
  EXPECT_THROW(fill_with(VFC::parameters::thickness(.4), domain), std::logic_error);
}

TEST(Fill, tells_where_a_direction_is_not_finite)
{
  const auto directions = [](const Point& p) {
    return std::array<double, 3>{0, p.x() > 0 ? nan : 1., 0};
  };
  const std::string message = refusal(
      Strange_domain(), VFC::parameters::thickness(.4).direction_field(std::cref(directions)));
  EXPECT_TRUE(contains(message, "direction_field is not finite at (")) << message;
}

TEST(Grow_fingers, tells_where_a_thickness_is_not_positive_and_finite)
{
  const Strange_domain domain;
  for(const double bad : {nan, -.1, 0., infinity}) {
    Curve curve =
        polyline({Point(-.2, 0, 0), Point(.2, 0, 0), Point(.2, .2, 0), Point(-.2, .2, 0)});
    VFC::Isotopy_guard_3<Traits, Strange_domain> guard(curve, domain);
    const auto field = [&](const Point& p) { return p.x() > 0 ? bad : .4; };
    EXPECT_THROW(VFC::grow_fingers(guard, VFC::parameters::thickness(field)),
                 std::invalid_argument);
  }
}

TEST(Fill, refuses_domains_whose_distances_contradict_them)
{
  for(const double bad : {nan, -1., infinity}) {
    Strange_domain domain;
    domain.room = [&](const Point&) { return bad; };
    const std::string message = refusal_of_domain(domain);
    EXPECT_TRUE(contains(message, "the domain contradicts itself: (")) << message;
  }
  Strange_domain narrow;
  narrow.room = [](const Point&) { return 0; };
  EXPECT_TRUE(contains(refusal_of_domain(narrow), "all at distance 0 from the boundary"));
  Strange_domain wide; // ever wider the farther one goes, and beyond its box
  wide.inside = [](const Point&) { return true; };
  wide.room = [](const Point& p) { return 1 + 1e-3 * std::abs(p.x()); };
  EXPECT_TRUE(contains(refusal_of_domain(wide), "the domain contradicts itself: "));
  Strange_domain half_space;
  half_space.inside = [](const Point& p) { return p.x() < 0; };
  half_space.room = [](const Point& p) { return -p.x(); };
  EXPECT_EQ(refusal_of_domain(half_space),
            "the domain contradicts itself: it reaches beyond its box");
}

TEST(Fill, refuses_domains_without_an_inside)
{
  Strange_domain nothing;
  nothing.inside = [](const Point&) { return false; };
  EXPECT_EQ(refusal_of_domain(nothing), "hardly any point of the domain's box is inside");
  Strange_domain stiff;
  stiff.triangle_inside = [](const Point&, const Point&, const Point&) { return false; };
  EXPECT_TRUE(contains(refusal_of_domain(stiff), "the domain contradicts itself: "));
  for(const CGAL::Bbox_3& box : {CGAL::Bbox_3(), CGAL::Bbox_3(nan, nan, nan, nan, nan, nan),
                                 CGAL::Bbox_3(1, 1, 1, -1, -1, -1)}) {
    Strange_domain domain;
    domain.box = [&] { return box; };
    EXPECT_EQ(refusal_of_domain(domain), "the domain's box is empty");
  }
  Strange_domain endless;
  endless.box = [] { return CGAL::Bbox_3(-infinity, -1, -1, infinity, 1, 1); };
  EXPECT_EQ(refusal_of_domain(endless), "the domain is unbounded");
}

TEST(Fill, refuses_coordinates_that_are_too_large_for_the_thickness)
{
  const double far = std::ldexp(1., 52);
  const VFC::Polygon_domain_3<Traits> plate(polygons::polygon(polygons::rectangle(far, 0, 20, 12)));
  EXPECT_TRUE(
      contains(refusal(plate, VFC::parameters::thickness(.6)), "too large for the thickness"));
}

// Distances along directions only steer.
TEST(Fill, ends_with_distances_along_directions_that_make_no_sense)
{
  for(const double bad : {nan, -1., 0., infinity}) {
    Strange_domain domain;
    domain.along = [&](double) { return bad; };
    const std::string message = refusal_of_domain(domain);
    EXPECT_TRUE(message.empty() || contains(message, "the domain contradicts itself: ")) << message;
  }
}

// Contents of the state of a filling, for a test to forge.
struct Forgery
{
  std::string fingerprint;
  Curve curve;
  double clearance;
  std::size_t certified, refused;
  internal::Filling_state state;

  template <typename Archive>
  void copy(Archive& archive)
  {
    archive(fingerprint);
    internal::copy_curve(archive, curve);
    archive(clearance, certified, refused);
    std::apply(archive, state.members());
  }
};

const VFC::Box_domain_3<> cube(Point(-2, -2, -2), Point(2, 2, 2));

VFC::Filling_parameters<Point> small_run(std::size_t iterations)
{
  VFC::Filling_parameters<Point> parameters;
  parameters.thickness = 0.5;
  parameters.round_bends = false;
  parameters.number_of_iterations = iterations;
  return parameters;
}

Forgery state_of_filling()
{
  VFC::Run_state state;
  VFC::Filling_parameters<Point> parameters = small_run(9);
  parameters.checkpoint = [&](const VFC::Run_checkpoint& moment) { state = moment.state(); };
  Curve curve;
  const auto result = VFC::fill(curve, cube, parameters);
  Forgery forgery;
  forgery.curve = Curve(result.start);
  internal::Byte_archive archive(state.body());
  forgery.copy(archive);
  return forgery;
}

VFC::Filling_result<Point> resume(Curve& curve, Forgery forgery)
{
  internal::Byte_archive archive;
  forgery.copy(archive);
  const VFC::Run_state state = VFC::Run_state::sealed(archive.bytes());
  VFC::Filling_parameters<Point> parameters = small_run(11);
  parameters.resume_from = &state;
  return VFC::fill(curve, cube, parameters);
}

VFC::Filling_result<Point> resumed(const Forgery& forgery)
{
  Curve curve;
  return resume(curve, forgery);
}

using State_changes = std::vector<std::function<void(internal::Filling_state&)>>;

TEST(Fill, refuses_states_whose_thickness_would_exhaust_memory)
{
  const Forgery genuine = state_of_filling();
  EXPECT_EQ(resumed(genuine).statistics.iterations, 11u);
  Forgery forged = genuine;
  forged.state.numbers[0] = 1e-9;
  EXPECT_EQ(refusal_of<VFC::Run_state_error>([&] { resumed(forged); }),
            "the state contradicts itself: its thickness is too small");
}

// A filling is inside its domain whatever its state says.
TEST(Fill, stays_inside_if_a_state_contradicts_itself)
{
  const Forgery genuine = state_of_filling();
  using State = internal::Filling_state;
  const State_changes changes = {
      [](State& s) { s.numbers[0] = 0.25; },   [](State& s) { s.numbers.push_back(1); },
      [](State& s) { s.stage = 1; },           [](State& s) { s.stage = 1000; },
      [](State& s) { s.numbers[0] = 1e9; },    [](State& s) { s.point_counts.push_back(0); },
      [](State& s) { s.lengths.values = {}; }, [](State& s) { s.max_displacement = 1e100; }};
  for(std::size_t k = 0; k < changes.size(); ++k) {
    Forgery forged = genuine;
    changes[k](forged.state);
    Curve curve;
    resume(curve, forged);
    EXPECT_TRUE(CGAL::Volume_filling_curves::is_embedded(curve)) << k;
    for(const Point& p : curve.points()) EXPECT_TRUE(cube.is_inside(p)) << k;
  }
}

TEST(Fill, refuses_states_with_numbers_that_no_run_has)
{
  internal::Filling_state valid;
  valid.stage = 1;
  valid.numbers = {0.5};
  valid.lengths.values = {3, 4};
  valid.max_displacement = 1;
  ASSERT_TRUE(valid.is_valid());
  using State = internal::Filling_state;
  const State_changes changes = {[](State& s) { s.numbers[0] = nan; },
                                 [](State& s) { s.numbers.clear(); },
                                 [](State& s) { s.lengths.values[1] = nan; },
                                 [](State& s) { s.lengths.values[0] = 0; },
                                 [](State& s) { s.max_displacement = nan; },
                                 [](State& s) { s.flow.step_size.time_step = -1; },
                                 [](State& s) { s.flow.step_size.time_step = nan; },
                                 [](State& s) { s.flow.step_size.turns = -2; },
                                 [](State& s) {
                                   s.points.emplace_back(nan, 0, 0);
                                   s.point_counts.push_back(1);
                                 },
                                 [](State& s) {
                                   const std::string bytes(sizeof s.idle_steps, '\x80');
                                   internal::Byte_archive archive{bytes};
                                   archive(s.idle_steps);
                                 }};
  for(std::size_t k = 0; k < changes.size(); ++k) {
    State forged = valid;
    changes[k](forged);
    EXPECT_FALSE(forged.is_valid()) << k;
  }
}

// An empty state to resume from stands for none.
TEST(Fill, is_not_sampled_to_the_end_if_the_time_is_over)
{
  Strange_domain domain;
  std::size_t samples = 0;
  domain.inside = [&](const Point& p) {
    ++samples;
    return domain.cube.is_inside(p);
  };
  const VFC::Run_state none;
  VFC::Filling_parameters<Point> parameters;
  parameters.thickness = 0.5;
  parameters.time_limit = 0;
  parameters.resume_from = &none;
  Curve curve;
  EXPECT_EQ(VFC::fill(curve, domain, parameters).status, VFC::Filling_status::LIMIT);
  EXPECT_LT(samples, 5000u);
}

} // namespace test_fill_refusals
