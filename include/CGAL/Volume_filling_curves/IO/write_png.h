// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_IO_WRITE_PNG_H
#define CGAL_VOLUME_FILLING_CURVES_IO_WRITE_PNG_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/Triangle_soup.h>
#include <CGAL/Volume_filling_curves/internal/png/Picture_shader.h>
#include <CGAL/Volume_filling_curves/internal/png/Scene_raster.h>
#include <CGAL/Volume_filling_curves/internal/png/corner_normals.h>
#include <CGAL/Volume_filling_curves/internal/png/png_file.h>
#include <CGAL/Volume_filling_curves/internal/svg/Curve_view.h>

#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Draws the curve of a view as a tube, and the surface around it as if it were of glass.
template <typename Network>
std::string png_picture(const Network& curve, Curve_view view)
{
  constexpr std::size_t pixels = 800, samples_per_side = 2;
  constexpr double scale = pixels * samples_per_side / Curve_view::picture_size;
  view.scale(scale);
  Scene_raster raster(pixels * samples_per_side, pixels * samples_per_side);
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
    raster.add_capsule(view.point(curve.source(e)), view.point(curve.target(e)), view.width() / 2,
                       curve.component(curve.source(e)));
  raster.add_surface(view.surface(), corner_normals(view.surface()));
  return to_png(Picture_shader(raster, samples_per_side)());
}

} // namespace internal
} // namespace Volume_filling_curves

namespace IO {

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief writes a picture of a curve as PNG, with 800 by 800 pixels.
 *
 * The curve is seen as by `write_svg()`. Each component is a tube of its own color, shaded, paler the
 * farther it is away. The picture does not depend on the curve's size and position, nor on any
 * display or graphics card.
 *
 * \param out the stream, opened in binary mode
 * \param curve the curve, closed or open, with or without junctions
 *
 * \return whether writing succeeded
 */
template <typename Traits>
bool write_png(std::ostream& out, const Volume_filling_curves::Curve_network_3<Traits>& curve)
{
  namespace internal = Volume_filling_curves::internal;
  out << internal::png_picture(curve, internal::Curve_view(curve));
  return out.good();
}

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief writes a picture of a curve and a translucent surface around it as PNG.
 *
 * The two are seen from the front, that is from positive z, and a little from the right and above,
 * where y is up.
 *
 * \tparam TriangleMesh a model of `FaceListGraph`
 *
 * \param out the stream, opened in binary mode
 * \param curve the curve
 * \param mesh the surface, in the same coordinates
 *
 * \return whether writing succeeded
 */
template <typename Traits, typename TriangleMesh>
bool write_png(std::ostream& out,
               const Volume_filling_curves::Curve_network_3<Traits>& curve,
               const TriangleMesh& mesh)
{
  namespace internal = Volume_filling_curves::internal;
  out << internal::png_picture(curve, internal::Curve_view(curve, internal::triangle_soup(mesh)));
  return out.good();
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_IO_WRITE_PNG_H
