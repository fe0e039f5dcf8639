// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_IO_CURVE_NETWORK_H
#define CGAL_VOLUME_FILLING_CURVES_IO_CURVE_NETWORK_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_format.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Polylines_to_curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/draft_to_network.h>
#include <CGAL/Volume_filling_curves/internal/polylines/Curve_paths.h>
#include <CGAL/Volume_filling_curves/internal/polylines/polyline_ranges.h>
#include <CGAL/Volume_filling_curves/internal/text/whole_files.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Polyline_conventions.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief constructs a curve network from polylines, and lists their defects.
 *
 * This function does the same as the constructor of `Curve_network_3` from polylines, but treats
 * defects like `IO::read_curve_network()`: it lists errors instead of throwing them, drops an edge
 * that occurs twice with a warning, and so on. It does not test whether edges meet. Takes
 * \cgalBigO{n \log n} time for `n` points.
 *
 * \tparam PolylineRange a model of `ConstRange` whose items are points, or ranges of points
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam NamedParameters a sequence of Named Parameters
 *
 * \param polylines the polylines; coordinates are rounded to `double`
 * \param network receives the network; it is unchanged if there is an error
 * \param defects receives all errors and warnings; their `line` is the number of the polyline,
 * counted from 1
 * \param np an optional sequence of the named parameters `point_map`, `closure` and `junctions` of
 * that constructor
 *
 * \returns whether there is no error
 */
template <typename PolylineRange,
          typename Traits,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
bool polylines_to_curve_network(const PolylineRange& polylines,
                                Curve_network_3<Traits>& network,
                                std::vector<Curve_defect>& defects,
                                const NamedParameters& np = parameters::default_values())
{
  const Junctions junctions = internal::junctions_of(np);
  internal::Polylines_to_curve_draft converter(junctions, internal::closure_of(np));
  internal::add_polylines(polylines, internal::point_map_of<PolylineRange>(np), converter);
  return internal::draft_to_network(converter.draft(), network, defects, junctions);
}

} // namespace Volume_filling_curves

namespace IO {

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief reads a curve network from a file, and lists its defects.
 *
 * The extension, in upper or lower case, determines the format:
 *
 * - `.obj`: Wavefront OBJ with vertices `v` and polylines `l`. A polyline that repeats its first
 *   index at the end is closed; polylines with a common vertex are connected. A record `fixed i j
 *   k` pins vertices. All other records are ignored. A file without `l` records is one closed curve
 *   through all vertices.
 * - `.polylines.txt`: one polyline per line, the number of its points followed by their
 *   coordinates. A polyline that repeats its first point at the end is closed. If junctions are
 *   allowed, equal end points of polylines are one node.
 *
 * If an `.obj` file without `l` records has a single face, with five or more corners, the boundary
 * of this face is read as a closed curve, with a warning.
 *
 * The program `vfc` reads and writes further formats, and converts files.
 *
 * `origin()` of the network returns the index of a node among the vertices of the file, from 0;
 * repeated points of `.polylines.txt` do not count. An edge that occurs twice is dropped, and an
 * edge of length zero is contracted, each with a warning. A line that turns straight back, such
 * as `l 1 2 3 2`, is an error.
 *
 * This function does not test whether the network is embedded, that is, whether edges meet only in
 * common nodes. Functions that require it test it themselves; `read_embedded_curve_network()` lists
 * edges that meet. Takes \cgalBigO{n \log n} time for `n` vertices.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param filename the name of the file
 * \param network receives the network; it is unchanged if there is an error
 * \param defects receives all errors and warnings, at most 1000 of a kind
 * \param junctions whether nodes may have more than two edges
 * \param closure which components are closed, overriding the file: `Closure::CLOSED` adds an edge
 * between the ends of each arc; `Closure::OPEN` removes the last edge of each closed curve in the
 * file, between the last and the first point of a polyline; `Closure::IF_REPEATED` follows the
 * file. Components with junctions do not change.
 *
 * \returns whether there is no error
 */
template <typename Traits>
bool read_curve_network(
    const std::string& filename,
    Volume_filling_curves::Curve_network_3<Traits>& network,
    std::vector<Volume_filling_curves::Curve_defect>& defects,
    Volume_filling_curves::Junctions junctions = Volume_filling_curves::Junctions::FORBIDDEN,
    std::optional<Volume_filling_curves::Closure> closure = std::nullopt)
{
  namespace internal = Volume_filling_curves::internal;
  internal::Curve_draft draft =
      internal::read_curve_draft(internal::curve_formats, filename, junctions, closure);
  return internal::draft_to_network(draft, network, defects, junctions);
}

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief reads a curve network from a file, like the overload above, without a list of defects.
 *
 * \returns whether there is no error
 */
template <typename Traits>
bool read_curve_network(
    const std::string& filename,
    Volume_filling_curves::Curve_network_3<Traits>& network,
    Volume_filling_curves::Junctions junctions = Volume_filling_curves::Junctions::FORBIDDEN,
    std::optional<Volume_filling_curves::Closure> closure = std::nullopt)
{
  std::vector<Volume_filling_curves::Curve_defect> defects;
  return read_curve_network(filename, network, defects, junctions, closure);
}

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief reads a curve network from a file, and lists its defects, including edges that meet.
 *
 * This function does the same as `read_curve_network()`, with the same parameters, but constructs
 * the network only if it is embedded (see `is_embedded()`). The time is \cgalBigO{n \log^2 n} for
 * `n` vertices unless many edges have intersecting bounding boxes.
 *
 * \returns whether there is no error
 */
template <typename Traits>
bool read_embedded_curve_network(
    const std::string& filename,
    Volume_filling_curves::Curve_network_3<Traits>& network,
    std::vector<Volume_filling_curves::Curve_defect>& defects,
    Volume_filling_curves::Junctions junctions = Volume_filling_curves::Junctions::FORBIDDEN,
    std::optional<Volume_filling_curves::Closure> closure = std::nullopt)
{
  namespace internal = Volume_filling_curves::internal;
  internal::Curve_draft draft =
      internal::read_curve_draft(internal::curve_formats, filename, junctions, closure);
  return internal::draft_to_embedded_network(draft, network, defects, junctions);
}

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief writes a curve network to a file, and reports errors.
 *
 * The extension determines the format, as in `read_curve_network()`. Coordinates have 17
 * significant digits. Reading the file restores positions, edges, pins and the numbering of the
 * nodes of every network that is embedded, not empty and at least 1e-150 in size. The format
 * `.polylines.txt` does not store pins and, for a network with junctions, the numbering. No format
 * stores the sets in which nodes slide (`Node_constraint`).
 *
 * The network is first written to a new file in the same folder, which replaces an existing file
 * once it is complete. Other programs never see an incomplete file, and an error leaves the old
 * file intact.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param filename the name of the file
 * \param network the network
 * \param error receives the error of the system, if any, and `std::errc::invalid_argument` if the
 * extension belongs to no format
 *
 * \returns whether the file was written
 *
 * \pre the network has no garbage
 */
template <typename Traits>
bool write_curve_network(const std::string& filename,
                         const Volume_filling_curves::Curve_network_3<Traits>& network,
                         std::error_code& error)
{
  namespace internal = Volume_filling_curves::internal;
  const auto* const format = internal::find_format(internal::curve_formats, filename);
  error = format == nullptr
              ? std::make_error_code(std::errc::invalid_argument)
              : internal::write_whole_file(filename, format->write(internal::Curve_paths(network)));
  return !error;
}

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief writes a curve network to a file, like the overload above, without an error code.
 *
 * \returns whether the file was written
 *
 * \pre the network has no garbage
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

#endif // CGAL_VOLUME_FILLING_CURVES_IO_CURVE_NETWORK_H
