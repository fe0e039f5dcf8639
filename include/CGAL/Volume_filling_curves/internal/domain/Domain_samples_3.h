// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DOMAIN_SAMPLES_3_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DOMAIN_SAMPLES_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Kernel_traits.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesMeasures
 * \headerfile CGAL/Volume_filling_curves/coverage.h
 *
 * \brief The class `Domain_samples_3` holds random points, uniform in a bounded domain.
 *
 * The same domain, number and seed give the same points on every platform. The construction calls
 * `is_inside()` for random points of the domain's box: on average, the number of samples times the
 * volume of the box over that of the domain.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3` with the same point type
 */
template <typename Traits, typename Domain>
class Domain_samples_3
{
public:
  /// the type of points
  using Point_3 = typename Traits::Point_3;

  /// the number of samples for the statistics of a report
  static constexpr std::size_t default_number = 20000;

  /*!
   * takes the samples.
   *
   * \param domain the domain, which must outlive the samples
   * \param number the number of samples
   * \param seed the seed of the random numbers
   * \param traits the traits object
   * \param go_further is called after every 1024 points of the box; if it returns `false`, the
   * sampling ends with fewer samples. None by default
   *
   * \throws std::invalid_argument if the domain is unbounded, if its box is empty or so large or
   * small that a double cannot hold its volume, if fewer than about one in 10,000 points of the box
   * are inside, or if `go_further` ended the sampling before the first sample
   */
  explicit Domain_samples_3(const Domain& domain,
                            std::size_t number = default_number,
                            std::uint64_t seed = 0,
                            const Traits& traits = Traits(),
                            const std::function<bool()>& go_further = nullptr)
      : m_domain(domain), m_traits(traits)
  {
    using Space = internal::Space_of<Domain>;
    const CGAL::Bbox_3 box = domain.bbox();
    if(!(box.x_span() > 0) || !(box.y_span() > 0) || (!Space::is_plane && !(box.z_span() > 0)))
      throw std::invalid_argument("the domain's box is empty");
    if(!std::isfinite(box.x_span() + box.y_span() + box.z_span()))
      throw std::invalid_argument("the domain is unbounded");
    const double box_volume = Space::content(box);
    if(!std::isnormal(box_volume))
      throw std::invalid_argument("a double cannot hold the volume of the domain's box; scale the "
                                  "domain by a power of two");
    // If every 10,000th point is inside, hundred fewer than expected have a chance of e^-50.
    const double max_attempts_per_sample = 10000, lag = 100;
    const std::size_t attempts_per_question = 1024;
    internal::Random_source random(seed);
    std::size_t attempts = 0;
    m_points.reserve(number);
    for(; m_points.size() < number; ++attempts) {
      const double enough = static_cast<double>(m_points.size()) + lag;
      if(static_cast<double>(attempts) >= max_attempts_per_sample * enough) throw_no_samples();
      if(go_further && attempts > 0 && attempts % attempts_per_question == 0 && !go_further())
        break;
      const Point_3 point = internal::to_point(Space::random_point(box, random), m_traits);
      if(domain.is_inside(point)) m_points.push_back(point);
    }
    if(number > 0 && m_points.empty()) throw_no_samples();
    if(attempts > 0)
      m_volume = box_volume * static_cast<double>(m_points.size()) / static_cast<double>(attempts);
  }

  /// returns the samples.
  const std::vector<Point_3>& points() const { return m_points; }

  /// returns the domain.
  const Domain& domain() const { return m_domain; }

  /// returns the traits object.
  const Traits& traits() const { return m_traits; }

  /// returns an estimate of the volume of the domain, or of the area of a planar one: that of the
  /// box times the share of its points that were inside.
  double volume() const { return m_volume; }

private:
  [[noreturn]] static void throw_no_samples()
  {
    throw std::invalid_argument("hardly any point of the domain's box is inside");
  }

  const Domain& m_domain;
  Traits m_traits;
  std::vector<Point_3> m_points;
  double m_volume = 0;
};

/// \cond SKIP_IN_MANUAL
template <typename Domain>
explicit Domain_samples_3(const Domain&, std::size_t = 0, std::uint64_t = 0) -> Domain_samples_3<
    Curve_flow_traits_3<typename Kernel_traits<typename Domain::Point_3>::Kernel>,
    Domain>;
/// \endcond

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DOMAIN_SAMPLES_3_H
