// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_UNFILLED_REASON_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_UNFILLED_REASON_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/filling/filling_estimates.h>
#include <CGAL/Volume_filling_curves/internal/text/number_text.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_result.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Thickness_fit.h>

#include <cstddef>
#include <iomanip>
#include <locale>
#include <sstream>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Reason, in English, why more of a domain than tolerated is farther than 2 r from the curve, or
// more of the curve nearer than r to another strand.

// returns whether there must be one
template <typename Result>
bool is_partial(const Result& result)
{
  return result.unfilled_fraction > tolerated_unfilled_fraction ||
         result.crowded_fraction > tolerated_crowded_fraction;
}

// returns the number with three digits
inline std::string rounded(double number)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::setprecision(3) << number;
  return out.str();
}

inline std::string too_thin(const Thickness_fit& fit)
{
  return "walls are too thin for r = " + rounded(fit.thickness) + " in " +
         rounded(100 * fit.thin_fraction) +
         " % of the volume, r = " + rounded(fit.fitting_thickness) + " would fit";
}

// Names a thickness that fits, if there is one and none is named yet.
template <typename Result>
std::string crowded(const Result& result, double fitting_thickness, bool is_named)
{
  const std::string text = "strands are nearer than r along " +
                           rounded(100 * result.crowded_fraction) + " % of the length";
  if(is_named || !(fitting_thickness < result.thickness_fit.thickness)) return text;
  return text + ", r = " + rounded(fitting_thickness) + " would leave them room";
}

// The empty regions in those parts of the inside that hold a curve.
struct Missed_regions
{
  std::size_t behind_necks = 0; // proved to be
  std::size_t others = 0;
};

// Also takes the thickness with which strands keep their distance, used if the curve is crowded.
template <typename Point_3>
std::string unfilled_reason(const Filling_result<Point_3>& result,
                            const Missed_regions& missed,
                            double uncrowded_thickness)
{
  std::string reason;
  const auto add = [&](const std::string& text) { reason += (reason.empty() ? "" : "; ") + text; };
  if(result.status == Filling_status::STALLED) add("no step could be certified any more");
  if(result.unreachable_parts > 0)
    add("no curve was started in " + std::to_string(result.unreachable_parts) + " of " +
        counted(result.parts, "part") + " of the inside");
  const bool is_thin = result.thickness_fit.thin_fraction > tolerated_unfilled_fraction;
  if(is_thin) add(too_thin(result.thickness_fit));
  if(result.crowded_fraction > tolerated_crowded_fraction)
    add(crowded(result, uncrowded_thickness, is_thin));
  if(missed.behind_necks > 0)
    add("the curve did not get through a neck narrower than r to " +
        counted(missed.behind_necks, "empty region"));
  if(missed.others > 0) add("the curve did not reach " + counted(missed.others, "empty region"));
  return reason.empty() ? "gaps between strands or along the boundary are wide" : reason;
}

// Returns the reason of LENGTH_NOT_REACHED.
inline std::string length_reason(double length, double required_length)
{
  return "the length is " + rounded(length) + ", not " + rounded(required_length);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_UNFILLED_REASON_H
