// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_SCALE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_SCALE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/Canonical_curve.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Certificate_reader.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Certificate_writer.h>
#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/Network_editor.h>
#include <CGAL/Volume_filling_curves/internal/domain/domain_concepts.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_result.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Unit of length of a filling. Terms of degree 6 overflow in a domain of size 2^170 and underflow
// in one of size 2^-170. Such a run therefore uses the size of the domain's box as unit, rounded to
// a power of two, which rounds no coordinate.

inline double max_coordinate_of(const CGAL::Bbox_3& box)
{
  double largest = 0;
  for(int i = 0; i < 3; ++i)
    largest = (std::max)({largest, std::abs((box.min)(i)), std::abs((box.max)(i))});
  return largest;
}

[[noreturn]] inline void refuse_size(double size, const std::string& demand)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "the domain's box has a largest coordinate of " << size << ", but " << demand;
  throw std::invalid_argument(text.str());
}

// Returns the unit for a domain with that box; 1 unless the domain is very large or very small.
// \throws std::invalid_argument if it is larger or smaller than any domain may be
template <typename Domain>
double length_unit(const CGAL::Bbox_3& box)
{
  constexpr int max_exponent = 128; // leaves 2^40 between the domain's size and that of edges
  const double size = max_coordinate_of(box);
  if(!(size > 0) || !std::isfinite(size)) return 1; // the survey says what is wrong
  const int exponent = std::ilogb(size);
  if(std::abs(exponent) <= max_exponent) return 1;
  if(size > max_coordinate || size < min_extent)
    refuse_size(size, "must be between 1e-150 and 1e150");
  if(!Is_scalable<Domain>::value)
    refuse_size(size, "must be between 1e-38 and 1e38 if the domain has no member function "
                      "scaled(); scale it by a power of two, which changes no bits of the result");
  return std::ldexp(1., exponent);
}

// Scaling of the lengths of a filling by a power of two, from the caller's unit to that of the run
// and back. Exact.

template <typename Traits>
typename Traits::Point_3 scaled(const typename Traits::Point_3& p,
                                double factor,
                                const Traits& traits)
{
  return to_point(Vector(factor * to_vector(p)), traits);
}

template <typename Traits>
Curve_network_3<Traits> scaled(Curve_network_3<Traits> curve, double factor)
{
  Network_editor<Curve_network_3<Traits>> editor(curve);
  for(const std::size_t v : curve.nodes()) {
    editor.move_node(v, scaled(curve.point(v), factor, curve.traits()));
    if(!curve.is_free(v)) editor.set_constraint(v, curve.constraint(v).scaled(factor));
  }
  return curve;
}

inline void scale(Thickness_fit& fit, double factor)
{
  fit.thickness *= factor;
  fit.fitting_thickness *= factor;
}

inline void scale(Run_progress& progress, double factor)
{
  progress.length *= factor;
  progress.thickness *= factor;
  progress.default_thickness *= factor;
  progress.expected_length *= factor;
}

// Takes the space, in which volumes are measured.
template <typename Space, typename Point_3, typename Traits>
void scale(Filling_result<Point_3>& result, double factor, const Traits& traits)
{
  result.thickness *= factor;
  result.default_thickness *= factor;
  result.medial_radius *= factor;
  result.min_bend_radius *= factor;
  result.min_strand_distance *= factor;
  for(Point_3& p : result.closest_points) p = scaled(p, factor, traits);
  result.min_wall_distance *= factor;
  result.point_nearest_to_wall = scaled(result.point_nearest_to_wall, factor, traits);
  scale(result.thickness_fit, factor);
  for(auto& region : result.empty_regions) {
    region.point = scaled(region.point, factor, traits);
    region.radius *= factor;
    region.volume *= Space::content(factor);
  }
  for(auto& excess : result.shape_excesses) {
    excess.point = scaled(excess.point, factor, traits);
    excess.value *= factor;
    excess.limit *= factor;
  }
  for(auto& polyline : result.start)
    for(Point_3& p : polyline) p = scaled(p, factor, traits);
  for(auto& neck : result.necks) {
    neck.wall = scaled(neck.wall, factor, traits);
    neck.end = scaled(neck.end, factor, traits);
    neck.length *= factor;
  }
}

// Returns a length in the other unit. \throws std::invalid_argument, naming the parameter, if it
// would overflow or underflow: 0 stands for a length that is not given
template <typename Tag>
double scaled_length(Tag tag, double length, double factor)
{
  const double result = factor * length;
  if(length != 0 && !std::isnormal(result))
    refuse_value(tag, length, "must be between 1e-307 and 1e307 times the size of the domain");
  return result;
}

template <typename Point_3, typename Traits>
Filling_parameters<Point_3> scaled(Filling_parameters<Point_3> parameters,
                                   double factor,
                                   const Traits& traits)
{
  using namespace internal_np;
  const auto scale = [&](auto tag, double& length) { length = scaled_length(tag, length, factor); };
  scale(thickness_t(), parameters.thickness);
  scale(length_t(), parameters.length);
  scale(bend_radius_t(), parameters.bend_radius);
  scale(strand_distance_t(), parameters.strand_distance);
  scale(wall_distance_t(), parameters.wall_distance);
  for(auto& port : parameters.ports) port.point = scaled(port.point, factor, traits);
  if(auto& field = parameters.thickness_field)
    field = [field, factor, traits](const Point_3& p) {
      return scaled_length(thickness_t(), field(scaled(p, 1 / factor, traits)), factor);
    };
  if(auto& field = parameters.direction_field)
    field = [field, factor, traits](const Point_3& p) {
      return field(scaled(p, 1 / factor, traits));
    };
  return parameters;
}

// A curve in other units as long as the scope exists.
template <typename Network>
class Scaled_scope
{
public:
  Scaled_scope(Network& curve, double factor) : m_curve(curve), m_factor(factor)
  {
    m_curve = scaled(m_curve, m_factor);
  }

  ~Scaled_scope() { m_curve = scaled(m_curve, 1 / m_factor); }

  Scaled_scope(const Scaled_scope&) = delete;
  Scaled_scope& operator=(const Scaled_scope&) = delete;

private:
  Network& m_curve;
  const double m_factor;
};

// Record of a motion with all coordinates multiplied by a power of two, which keeps the order of
// the nodes. The caller scales the start and end curves likewise.
template <typename Curve>
std::string scaled_record(std::string_view bytes,
                          double factor,
                          const Curve& start,
                          const Curve& end)
{
  Certificate_reader reader(bytes);
  Certificate_writer writer;
  Certificate_header header = reader.header();
  header.curve = Canonical_curve(start).digest();
  writer.write(header);
  for(auto operation = reader.operation(); operation.kind != Certificate_operation::Kind::END;
      operation = reader.operation()) {
    for(double& x : operation.position) x *= factor;
    writer.write(operation);
  }
  const Certificate_trailer trailer = reader.trailer();
  writer.write_end(trailer.nodes, trailer.edges, Canonical_curve(end).digest());
  writer.write_record_hash(sha256(writer.bytes()));
  return writer.bytes();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_SCALE_H
