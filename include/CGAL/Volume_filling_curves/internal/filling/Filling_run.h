// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_RUN_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_RUN_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>
#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Filling_parameters.h>
#include <CGAL/Volume_filling_curves/Filling_result.h>
#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/Thickness_fit.h>
#include <CGAL/Volume_filling_curves/internal/curve/check_embedded.h>
#include <CGAL/Volume_filling_curves/internal/filling/Domain_survey.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filler.h>
#include <CGAL/Volume_filling_curves/internal/filling/check_inside.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_thickness.h>
#include <CGAL/Volume_filling_curves/internal/filling/unfilled_reason.h>
#include <CGAL/Volume_filling_curves/internal/fingers/Finger_tree.h>
#include <CGAL/Volume_filling_curves/internal/state/Run_saver.h>
#include <CGAL/Volume_filling_curves/internal/state/State_reader.h>
#include <CGAL/Volume_filling_curves/internal/state/State_writer.h>
#include <CGAL/Volume_filling_curves/internal/state/domain_hash.h>
#include <CGAL/Volume_filling_curves/internal/state/run_facts.h>
#include <CGAL/Volume_filling_curves/internal/support/Deadline.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Real_timer.h>

#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// A run of fill(): surveys the domain, warns if it is too thin, places a circle in each part if no
// curves are given, lets fingers reach out from them unless they are to grow, lets them fill the
// domain, and tells what was not filled, and why.
template <typename Traits, typename Domain, typename ConcurrencyTag, typename Visitor>
class Filling_run
{
  using Network = Curve_network_3<Traits>;
  using Point_3 = typename Traits::Point_3;
  using Survey = Domain_survey<Traits, Domain, ConcurrencyTag>;
  using Flow = Curve_flow_3<Traits, Domain, ConcurrencyTag>;
  using Parameters = Filling_parameters<Point_3>;
  using Result = Filling_result<Point_3>;

public:
  // The timer has been started.
  Filling_run(Network& curves,
              const Domain& domain,
              const Parameters& parameters,
              const Real_timer& timer,
              Visitor& visitor)
      : m_curves(curves),
        m_domain(domain),
        m_parameters(parameters),
        m_deadline(timer, parameters.time_limit),
        m_visitor(visitor),
        m_survey(domain, parameters, curves.traits(), m_deadline),
        m_fit(m_survey.thickness_fit()),
        m_saver(parameters, [this] { return facts(); })
  {}

  Result operator()()
  {
    if(m_fit.thin_fraction > tolerated_unfilled_fraction) m_visitor.on_thin_domain(m_fit);
    if(m_curves.number_of_nodes() == 0) place_circles();
    check_embedded(m_curves);
    check_inside(m_curves, m_domain);
    Result result = grow();
    report_parts(result);
    return result;
  }

private:
  void place_circles()
  {
    m_circles = m_survey.circles();
    m_curves = Network(m_circles, CGAL::parameters::default_values(), m_curves.traits());
  }

  // All that the run depends on. Fields are known by their values at the samples.
  Run_facts facts() const
  {
    State_writer thicknesses, directions;
    if(m_parameters.thickness_field)
      for(const Point_3& p : m_survey.samples().points()) thicknesses(m_survey.thickness_at(p));
    if(m_parameters.direction_field)
      for(const Point_3& p : m_survey.samples().points())
        for(const double coordinate : m_parameters.direction_field(p)) directions(coordinate);
    return run_facts("fill", m_parameters,
                     {{"curve", state_hash(m_curves)},
                      {"domain", domain_hash(m_domain, m_curves.traits())},
                      {"thickness field", to_hex(sha256(thicknesses.bytes()))},
                      {"direction field", to_hex(sha256(directions.bytes()))}});
  }

  Result grow()
  {
    State_reader* const reader = m_saver.reader();
    if(reader) (*reader)(m_curves);
    Isotopy_guard_3<Traits, Domain> guard(m_curves, m_domain);
    if(m_parameters.certificate) guard.start_recording();
    if(reader)
      (*reader)(guard);
    else if(m_parameters.start == Filling_start::TREE)
      reach_out(guard);
    Filler<Flow, typename Survey::Samples, Visitor> filler(
        guard, m_survey.samples(), m_survey.distances_to_boundary(), m_parameters,
        start_thickness(), m_survey.widest_radius(), [&] { return reach_out(guard); }, m_deadline,
        m_visitor, m_saver);
    const Result result = filler();
    if(m_parameters.certificate) *m_parameters.certificate = guard.certificate();
    return result;
  }

  // Returns how many fingers have grown.
  std::size_t reach_out(Isotopy_guard_3<Traits, Domain>& guard) const
  {
    const auto thickness = [this](const Point_3& p) { return m_survey.thickness_at(p); };
    auto tree = finger_tree(guard, m_domain, thickness, m_parameters.random_seed, m_deadline);
    tree.follow(m_parameters.direction_field, m_parameters.direction_weight);
    tree.grow();
    return tree.number_of_fingers();
  }

  double start_thickness() const
  {
    return m_parameters.thickness_field
               ? mean_thickness(m_parameters.thickness_field, m_curves.points())
               : m_survey.thickness();
  }

  void report_parts(Result& result) const
  {
    result.parts = m_survey.number_of_wide_parts();
    result.unreachable_parts = m_survey.number_of_wide_parts_without(m_curves);
    result.thickness_fit = m_fit;
    result.start = m_circles;
    const bool has_ended_early =
        result.status != Filling_status::PARTIAL && result.status != Filling_status::STALLED;
    if(!has_ended_early && result.unfilled_fraction > tolerated_unfilled_fraction)
      result.reason = unfilled_reason(result);
  }

  Network& m_curves;
  const Domain& m_domain;
  const Parameters& m_parameters;
  const Deadline m_deadline;
  Visitor& m_visitor;
  const Survey m_survey;
  const Thickness_fit m_fit;
  Run_saver m_saver;
  std::vector<std::vector<Point_3>> m_circles; // if the run starts from them
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_RUN_H
