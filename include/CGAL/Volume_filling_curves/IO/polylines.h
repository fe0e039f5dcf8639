// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_IO_POLYLINES_H
#define CGAL_VOLUME_FILLING_CURVES_IO_POLYLINES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/IO/Curve_defect.h>
#include <CGAL/Volume_filling_curves/internal/IO/Curve_file.h>
#include <CGAL/Volume_filling_curves/internal/IO/Curve_format.h>
#include <CGAL/Volume_filling_curves/internal/IO/Curve_strands.h>
#include <CGAL/Volume_filling_curves/internal/IO/Polylines_to_curve_file.h>
#include <CGAL/Volume_filling_curves/internal/IO/make_network.h>
#include <CGAL/Volume_filling_curves/internal/IO/whole_files.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <boost/range/value_type.hpp>

#include <cstddef>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief constructs a curve network from polylines.
 *
 * By \cgal's habit a polyline is closed if its last point repeats the first. The repeated point is
 * no new node; all others are numbered in the order of the range, and `origin()` of the network
 * gives this number. If junctions are allowed, equal end points of polylines are one node.
 *
 * The network is constructed only if it is embedded, that is, if no two edges meet elsewhere than
 * in a common node; this is decided with exact predicates. The time is
 * \cgalBigO{n \log^2 n} for `n` points unless many edges have intersecting bounding boxes.
 *
 * \tparam PolylineRange a model of `ConstRange` whose value type is a model of `ConstRange`
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam NamedParameters a sequence of Named Parameters
 *
 * \param polylines the polylines; coordinates are rounded to `double`
 * \param network receives the network; it does not change if there is an error
 * \param defects receives all errors and warnings; their `line` is the number of the polyline,
 * counted from 1
 * \param junctions tells whether nodes may have more than two edges
 * \param np optional named parameters
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{point_map}
 *     \cgalParamDescription{a property map that gives the points of a polyline}
 *     \cgalParamType{a model of `ReadablePropertyMap` whose key type is the value type of the
 *                    polylines and whose value type is a 3D point of a \cgal kernel}
 *     \cgalParamDefault{`CGAL::Identity_property_map`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return whether there is no error
 */
template <typename PolylineRange,
          typename Traits,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
bool polylines_to_curve_network(const PolylineRange& polylines,
                                Curve_network_3<Traits>& network,
                                std::vector<Curve_defect>& defects,
                                Junctions junctions = Junctions::FORBIDDEN,
                                const NamedParameters& np = CGAL::parameters::default_values())
{
  using Polyline = typename boost::range_value<PolylineRange>::type;
  using Item = typename boost::range_value<Polyline>::type;
  const auto point_map = CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, CGAL::internal_np::point_map),
      CGAL::Identity_property_map<Item>());
  internal::Polylines_to_curve_file converter(junctions);
  std::vector<internal::Polylines_to_curve_file::Point> points;
  std::size_t line = 0;
  for(const Polyline& polyline : polylines) {
    ++line;
    points.clear();
    for(const Item& item : polyline) {
      const auto& p = get(point_map, item);
      points.push_back(
          {{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}, line});
    }
    converter.add(points, line);
  }
  return internal::make_network(converter.file(), network, defects, junctions);
}

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief writes the curves of a network as polylines.
 *
 * There is one polyline for every component without junctions; it repeats its first point at the
 * end if the component is closed. Components with junctions are cut there. Takes linear time.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam OutputIterator a model of `OutputIterator` that accepts
 * `std::vector<Traits::Point_3>`
 *
 * \param network the network
 * \param polylines receives the polylines
 *
 * \return the output iterator behind the last polyline
 */
template <typename Traits, typename OutputIterator>
OutputIterator curve_network_to_polylines(const Curve_network_3<Traits>& network,
                                          OutputIterator polylines)
{
  for(const auto& strand : internal::Curve_strands(network).strands) {
    std::vector<typename Traits::Point_3> polyline;
    polyline.reserve(strand.size());
    for(const std::size_t v : strand) polyline.push_back(network.point(v));
    *polylines++ = std::move(polyline);
  }
  return polylines;
}

} // namespace Volume_filling_curves

namespace IO {

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief reads a curve network from a file, and lists everything that is wrong with it.
 *
 * The extension tells the format, in upper or lower case:
 *
 * - `.obj`: Wavefront OBJ with vertices `v` and polylines `l`. A polyline that repeats its first
 *   index at the end is closed; polylines with a common vertex are connected. A record
 *   `fixed i j k` pins vertices. All other records are ignored. Without any `l` there is one closed
 *   curve through all vertices.
 * - `.polylines.txt`: one polyline per line, the number of its points followed by their
 *   coordinates. A polyline that repeats its first point at the end is closed. If junctions are
 *   allowed, equal end points of polylines are one node.
 *
 * `origin()` of the network gives the place of a node among the vertices of the file, from 0; the
 * repeated points of `.polylines.txt` do not count. An edge that is given twice is dropped and an
 * edge of length zero contracted, with a warning.
 *
 * The network is constructed only if it is embedded, that is, if no two edges meet elsewhere than
 * in a common node; this is decided with exact predicates. The time is
 * \cgalBigO{n \log^2 n} for `n` vertices unless many edges have intersecting bounding boxes.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param filename the name of the file
 * \param network receives the network; it does not change if there is an error
 * \param defects receives all errors and warnings, at most 1000 of a kind
 * \param junctions tells whether nodes may have more than two edges
 *
 * \return whether there is no error
 */
template <typename Traits>
bool read_curve_network(
    const std::string& filename,
    Volume_filling_curves::Curve_network_3<Traits>& network,
    std::vector<Volume_filling_curves::Curve_defect>& defects,
    Volume_filling_curves::Junctions junctions = Volume_filling_curves::Junctions::FORBIDDEN)
{
  using Volume_filling_curves::Curve_defect_kind;
  namespace internal = Volume_filling_curves::internal;
  defects.clear();
  std::string text;
  const auto* const format = internal::Curve_format::of(filename);
  if(format == nullptr)
    defects.push_back(
        {Curve_defect_kind::UNKNOWN_FORMAT, "curves are .obj or .polylines.txt files"});
  else if(const std::error_code error = internal::read_whole_file(filename, text))
    defects.push_back({Curve_defect_kind::UNREADABLE_FILE, error.message()});
  if(!defects.empty()) return false;
  internal::Curve_file file = format->read(text, junctions);
  return internal::make_network(file, network, defects, junctions);
}

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief reads a curve network from a file.
 *
 * As the overload above, for those who need not know what is wrong.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param filename the name of the file
 * \param network receives the network; it does not change if there is an error
 * \param junctions tells whether nodes may have more than two edges
 *
 * \return whether there is no error
 */
template <typename Traits>
bool read_curve_network(
    const std::string& filename,
    Volume_filling_curves::Curve_network_3<Traits>& network,
    Volume_filling_curves::Junctions junctions = Volume_filling_curves::Junctions::FORBIDDEN)
{
  std::vector<Volume_filling_curves::Curve_defect> defects;
  return read_curve_network(filename, network, defects, junctions);
}

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief writes a curve network to a file, and tells what went wrong.
 *
 * The extension tells the format as in `read_curve_network()`. Coordinates have 17 significant
 * digits, so that reading the file gives the very same network, down to the numbers of its nodes.
 * `.polylines.txt` does not hold which nodes are pinned, and of a network with junctions not the
 * numbers of its nodes.
 *
 * The network is written to a new file in the same folder, which replaces an existing one when it
 * is complete: no other program sees a part of it, and an error leaves the old file as it was.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param filename the name of the file
 * \param network the network
 * \param error receives the error of the system, if any, and
 * `std::errc::invalid_argument` if the extension is unknown
 *
 * \return whether the file was written
 */
template <typename Traits>
bool write_curve_network(const std::string& filename,
                         const Volume_filling_curves::Curve_network_3<Traits>& network,
                         std::error_code& error)
{
  namespace internal = Volume_filling_curves::internal;
  const auto* const format = internal::Curve_format::of(filename);
  error =
      format == nullptr
          ? std::make_error_code(std::errc::invalid_argument)
          : internal::write_whole_file(filename, format->write(internal::Curve_strands(network)));
  return !error;
}

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief writes a curve network to a file.
 *
 * As the overload above, for those who need not know what went wrong.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param filename the name of the file
 * \param network the network
 *
 * \return whether the file was written
 */
template <typename Traits>
bool write_curve_network(const std::string& filename,
                         const Volume_filling_curves::Curve_network_3<Traits>& network)
{
  std::error_code error;
  return write_curve_network(filename, network, error);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_IO_POLYLINES_H
