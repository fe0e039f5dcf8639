// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_IO_CURVE_FRAMES_H
#define CGAL_VOLUME_FILLING_CURVES_IO_CURVE_FRAMES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve_files/pvd_writer.h>
#include <CGAL/Volume_filling_curves/internal/text/whole_files.h>

#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief The class `Curve_frame` stands for a curve at one time of a motion, and for the file that
 * it is in.
 */
struct Curve_frame
{
  double time;          ///< the time, in any unit, for example the number of the iteration
  std::string filename; ///< the name of a `.vtp` file, relative to the file that lists the frames
};

} // namespace Volume_filling_curves

namespace IO {

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief writes a list of frames, a `.pvd` file of ParaView, which plays them as a film.
 *
 * The frames themselves are written by `write_curve_network()`, as `.vtp` files. The file is
 * replaced as by that function.
 *
 * \param filename the name of the file
 * \param frames the frames, in the order of their times
 * \param error receives the error of the system, if any
 *
 * \return whether the file was written
 */
inline bool write_curve_frames(const std::string& filename,
                               const std::vector<Volume_filling_curves::Curve_frame>& frames,
                               std::error_code& error)
{
  namespace internal = Volume_filling_curves::internal;
  error = internal::write_whole_file(filename, internal::to_pvd(frames));
  return !error;
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_IO_CURVE_FRAMES_H
