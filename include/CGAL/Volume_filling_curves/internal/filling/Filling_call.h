// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_CALL_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_CALL_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/Any_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/filling/Domain_survey.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_run.h>
#include <CGAL/Volume_filling_curves/internal/filling/Visitor_in_unit.h>
#include <CGAL/Volume_filling_curves/internal/filling/scale.h>
#include <CGAL/Volume_filling_curves/internal/guard/Motion_record.h>
#include <CGAL/Volume_filling_curves/internal/parameters/Thickness.h>
#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_result.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Named_function_parameters.h>

#include <functional>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Call of fill(): makes the domain, checks the parameters, and runs in a unit of length that suits
// the domain.
template <typename Traits, typename ConcurrencyTag, typename Visitor>
class Filling_call
{
  using Network = Curve_network_3<Traits>;
  using Point_3 = typename Traits::Point_3;
  using Parameters = Filling_parameters<Point_3>;
  using Result = Filling_result<Point_3>;

public:
  Filling_call(Network& curves, const Parameters& parameters, Visitor& visitor)
      : m_curves(curves),
        m_parameters(parameters),
        m_visitor(visitor),
        m_watch(parameters.time_limit, progress_in_unit())
  {}

  // Takes a function that returns the domain, or a reference to it. If the time is over before the
  // domain is made, the curves remain unchanged.
  template <typename MakeDomain>
  Result operator()(const MakeDomain& make_domain)
  {
    m_watch.begin(Run_stage::PREPARING);
    try {
      const auto& domain = [&]() -> decltype(auto) {
        const Watched_scope scope(&m_watch);
        return make_domain();
      }();
      return fill(domain);
    } catch(const Run_stopped&) {
      return unprepared();
    }
  }

private:
  std::function<bool(const Run_progress&)> progress_in_unit()
  {
    if(!m_parameters.progress) return nullptr;
    return [this](Run_progress progress) {
      scale(progress, m_unit);
      return m_parameters.progress(progress);
    };
  }

  template <typename Domain>
  Result fill(const Domain& domain)
  {
    const double size = diagonal(domain.bbox());
    check(size);
    if(auto& field = m_parameters.thickness_field) field = field_in_domain(field, size);
    m_unit = length_unit<Domain>(domain.bbox());
    if constexpr(Is_scalable<Domain>::value)
      if(m_unit != 1) return fill_in_unit(domain);
    return run(domain, m_parameters);
  }

  // Throws std::invalid_argument if a domain with a box of that size cannot be filled.
  void check(double size) const
  {
    check_parameters(m_parameters);
    check_volume_shares(m_parameters, m_curves.number_of_nodes() > 0);
    check_thickness(m_parameters.thickness, size, "the domain");
    if(m_parameters.bend_radius > size)
      refuse_value(internal_np::bend_radius_t(), m_parameters.bend_radius,
                   not_larger_than("the domain", size));
    if(m_parameters.strand_distance > size)
      refuse_value(internal_np::strand_distance_t(), m_parameters.strand_distance,
                   not_larger_than("the domain", size));
    if(m_parameters.length > 0 && (m_parameters.thickness > 0 || m_parameters.thickness_field))
      refuse_value(internal_np::length_t(), m_parameters.length, "a thickness is given as well");
  }

  template <typename Domain>
  Result fill_in_unit(const Domain& domain)
  {
    const Network start = m_curves;
    Result result;
    {
      const Scaled_scope scope(m_curves, 1 / m_unit);
      const double factor = 1 / m_unit;
      result = run(domain.scaled(factor), scaled(m_parameters, factor, m_curves.traits()));
    }
    if(m_parameters.certificate) {
      const Network circles(result.start, CGAL::parameters::default_values(), m_curves.traits());
      *m_parameters.certificate =
          Isotopy_certificate(scaled_record(m_parameters.certificate->bytes(), m_unit,
                                            result.start.empty() ? start : circles, m_curves));
    }
    return result;
  }

  template <typename Domain>
  Result run(const Domain& domain, const Parameters& parameters)
  {
    const auto& any = any_domain(domain);
    using Domain_3 = std::decay_t<decltype(any)>;
    using Flow = Curve_flow_3<Traits, Domain_3, ConcurrencyTag>;
    Visitor_in_unit<Flow, Visitor> visitor(m_visitor, m_unit);
    const Domain_survey<Traits, Domain_3, ConcurrencyTag> survey(any, parameters, m_curves.traits(),
                                                                 m_watch, m_unit);
    return Filling_run<Traits, Domain_3, ConcurrencyTag>(m_curves, survey, visitor, m_unit)();
  }

  Result unprepared() const
  {
    Result result;
    if(m_watch.is_interrupted()) result.status = Filling_status::INTERRUPTED;
    result.medial_radius = result.gradient_norm = result.unfilled_fraction =
        result.uncovered_fraction = result.thickness_fit.thin_fraction =
            result.thickness_fit.fitting_thickness = std::numeric_limits<double>::quiet_NaN();
    certify_no_change(m_curves, m_parameters.certificate);
    return result;
  }

  Network& m_curves;
  Parameters m_parameters;
  Visitor& m_visitor;
  double m_unit = 1; // until the domain is known
  Run_watch m_watch;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_CALL_H
