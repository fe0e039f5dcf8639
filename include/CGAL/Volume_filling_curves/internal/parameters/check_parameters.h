// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_CHECK_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_CHECK_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/parameters/parameter_tables.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>

#include <cmath>
#include <cstddef>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Checks of parameters. Errors about a single value have one form: "screening is -1, but must be
// positive and finite".

inline bool is_positive(double x)
{
  return x > 0 && std::isfinite(x);
}

inline bool is_in_range(double x, Range range)
{
  switch(range) {
  case Range::POSITIVE:
    return is_positive(x);
  case Range::UP_TO_ONE:
    return x > 0 && x <= 1;
  case Range::UP_TO_A_MILLION:
    return x > 0 && x <= 1e6;
  case Range::NOT_NEGATIVE:
    return x == 0 || is_positive(x);
  case Range::NOT_NEGATIVE_OR_NEVER:
    return x >= 0;
  default:
    return true;
  }
}

inline const char* demand(Range range)
{
  switch(range) {
  case Range::POSITIVE:
    return "must be positive and finite";
  case Range::UP_TO_ONE:
    return "must be positive and at most 1";
  case Range::UP_TO_A_MILLION:
    return "must be positive and at most 1000000";
  case Range::NOT_NEGATIVE:
    return "must be finite and not negative";
  case Range::NOT_NEGATIVE_OR_NEVER:
    return "must not be negative";
  default:
    return "";
  }
}

// Throws "NAME is VALUE, but DEMAND". By name, since a template of the tag would be compiled for
// each parameter.
template <typename Value>
[[noreturn]] void refuse_value(const char* name, const Value& value, const std::string& demand)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << name << " is " << value << ", but " << demand;
  throw std::invalid_argument(text.str());
}

template <typename Tag, typename Value>
[[noreturn]] void refuse_value(Tag tag, const Value& value, const std::string& demand)
{
  refuse_value(internal_np::name_of(tag), value, demand);
}

template <typename Value>
void check_value(const char* name, const Value& value, Range range)
{
  if(!is_in_range(static_cast<double>(value), range)) refuse_value(name, value, demand(range));
}

template <typename Parameters, typename Row>
void check_parameter(const Parameters& p, const Row& row)
{
  if constexpr(std::is_arithmetic_v<typename Row::Value>)
    check_value(internal_np::name_of(typename Row::Tag()), p.*row.member, row.range);
}

// Throws std::invalid_argument if a value is out of its range.
template <typename Parameters>
void check_parameters(const Parameters& p)
{
  std::apply([&](const auto&... row) { (check_parameter(p, row), ...); },
             parameter_table<Parameters>());
}

inline std::string not_larger_than(const std::string& owner, double size)
{
  std::ostringstream demand;
  demand.imbue(std::locale::classic());
  demand << "must not be larger than " << owner << ", whose box has a diagonal of " << size;
  return demand.str();
}

// Throws std::invalid_argument if the thickness is larger than its owner, a curve or a domain.
inline void check_thickness(double thickness, double size, const std::string& owner)
{
  if(thickness > size)
    refuse_value(internal_np::thickness_t(), thickness, not_larger_than(owner, size));
}

// Returns whether curves of that length would have too many nodes if all edges were as short as the
// spacing, in units of the thickness, allows: 20 million take some 20 GB.
inline bool has_too_many_nodes(double length, double spacing, double thickness)
{
  constexpr double most = 2e7;
  return length / most > spacing * thickness;
}

// Throws std::invalid_argument if a share is not positive and finite, if the start is not
// Filling_start::TREE, which alone heeds shares, or if there are neither curves nor ports.
template <typename Point_3>
void check_volume_shares(const Filling_parameters<Point_3>& parameters, bool has_curves)
{
  const auto& shares = parameters.volume_shares;
  for(std::size_t c = 0; c < shares.size(); ++c)
    if(!(shares[c] > 0 && std::isfinite(shares[c])))
      refuse_value(internal_np::volume_shares_t(), shares[c],
                   "the share of component " + std::to_string(c) + " must be positive and finite");
  if(!shares.empty() && parameters.start != Filling_start::TREE)
    throw std::invalid_argument("volume_shares: only fingers divide the volume, and curves that "
                                "start from a circle have none");
  if(!shares.empty() && !has_curves && parameters.ports.empty())
    throw std::invalid_argument("volume_shares: there are neither curves nor ports, and a single "
                                "curve fills each connected part of the domain");
}

// Throws std::invalid_argument unless there is a share for each component, or none at all.
inline void check_number_of_shares(const std::vector<double>& shares, std::size_t components)
{
  if(!shares.empty() && shares.size() != components)
    throw std::invalid_argument("volume_shares: the number of shares is " +
                                std::to_string(shares.size()) + ", but that of components is " +
                                std::to_string(components));
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_CHECK_PARAMETERS_H
