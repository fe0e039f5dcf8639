// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_THICKNESS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_THICKNESS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/text/number_text.h>

#include <algorithm>
#include <functional>
#include <locale>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Throws std::invalid_argument: "thickness is VALUE at POINT, but DEMAND".
template <typename Point_3>
[[noreturn]] void refuse_thickness(double value, const Point_3& p, const std::string& demand)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "thickness is " << value << " at " << point_text(p) << ", but " << demand;
  throw std::invalid_argument(text.str());
}

// Returns the value of a field at a point. Throws std::invalid_argument if it is not positive and
// finite: a search for points at a distance of NaN never ends.
template <typename Point_3>
double checked_thickness(double value, const Point_3& p)
{
  if(!is_positive(value)) refuse_thickness(value, p, demand(Range::POSITIVE));
  return value;
}

// Returns a field that throws std::invalid_argument where the given one is not positive and finite,
// or larger than the domain, of that size.
template <typename Point_3>
std::function<double(const Point_3&)> field_in_domain(std::function<double(const Point_3&)> field,
                                                      double size)
{
  return [field = std::move(field), size](const Point_3& p) {
    const double value = checked_thickness(field(p), p);
    if(value > size) refuse_thickness(value, p, not_larger_than("the domain", size));
    return value;
  };
}

// Thickness of a curve: a number or a field, times a factor, times a local thinning. It is passed
// on by value. Safe to call concurrently if the field is.
template <typename Point_3>
class Thickness
{
public:
  using Field = std::function<double(const Point_3&)>;

  // Takes a number, 0 if it is still to be found; or a field, whose mean the number may be.
  explicit Thickness(double number = 0, Field field = nullptr)
      : m_number(number), m_field(std::move(field))
  {}

  bool is_given() const { return m_field || m_number > 0; }

  // Whether it varies from point to point.
  bool varies() const { return m_field || m_thinning; }

  double number() const { return m_number; }
  void set_number(double number) { m_number = number; }

  // Throws std::invalid_argument if the field is not positive and finite at the point.
  double operator()(const Point_3& p) const
  {
    const double thickness = m_field ? m_factor * checked_thickness(m_field(p), p) : m_number;
    return m_thinning ? (std::max)(thickness, m_min) * m_thinning(p) : (std::max)(thickness, m_min);
  }

  template <typename Points>
  std::vector<double> at_each(const Points& points) const
  {
    std::vector<double> values;
    values.reserve(points.size());
    for(const Point_3& p : points) values.push_back((*this)(p));
    return values;
  }

  // Returns the mean of some values, or the number if the thickness does not vary.
  double mean(const std::vector<double>& values) const
  {
    if(!varies() || values.empty()) return m_number;
    return std::accumulate(values.begin(), values.end(), 0.) / static_cast<double>(values.size());
  }

  // Returns the thickness with the mean at some points as its number, if it varies.
  template <typename Points>
  Thickness averaged_at(const Points& points) const
  {
    Thickness result = *this;
    if(varies()) result.m_number = mean(at_each(points));
    return result;
  }

  // Returns the thickness, raised to a minimum where it is less.
  Thickness raised_to(double min) const
  {
    Thickness result = *this;
    result.m_min = min;
    result.m_number = (std::max)(m_number, min);
    return result;
  }

  friend Thickness operator*(double factor, Thickness thickness)
  {
    thickness.m_number *= factor;
    thickness.m_min *= factor;
    thickness.m_factor *= factor;
    return thickness;
  }

  // Returns the thickness times a function of the point, which replaces any former one.
  Thickness thinned(Field thinning) const
  {
    Thickness result = *this;
    result.m_thinning = std::move(thinning);
    return result;
  }

private:
  double m_number, m_factor = 1, m_min = 0;
  Field m_field, m_thinning; // none if it is the same everywhere
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_THICKNESS_H
