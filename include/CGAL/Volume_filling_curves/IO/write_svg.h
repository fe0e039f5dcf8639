// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_IO_WRITE_SVG_H
#define CGAL_VOLUME_FILLING_CURVES_IO_WRITE_SVG_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/Triangle_soup.h>
#include <CGAL/Volume_filling_curves/internal/svg/Curve_view.h>
#include <CGAL/Volume_filling_curves/internal/svg/Stroke_layers.h>
#include <CGAL/Volume_filling_curves/internal/svg/Svg_painter.h>

#include <ostream>

namespace CGAL {
namespace IO {

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief writes a picture of a curve as SVG, a vector format that every browser shows.
 *
 * The curve is seen along its shortest principal axis. Each component is a tube of its own color,
 * paler the farther it is away, and interrupted where it passes under a strand. The picture does not
 * depend on the curve's size and position. Takes \f$O(n \log n + k)\f$ time for \f$n\f$ nodes and
 * \f$k\f$ places where strands come close in the picture.
 *
 * \param out the stream
 * \param curve the curve, closed or open, with or without junctions
 *
 * \return whether writing succeeded
 */
template <typename Traits>
bool write_svg(std::ostream& out, const Volume_filling_curves::Curve_network_3<Traits>& curve)
{
  namespace internal = Volume_filling_curves::internal;
  const internal::Curve_view view(curve);
  const internal::Stroke_layers layers(curve, view);
  internal::Svg_painter(layers, view.width(), out)(curve, view);
  return out.good();
}

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief writes a picture of a curve and the silhouette of a surface around it as SVG.
 *
 * The two are seen from the front, that is from positive z, and a little from the right and above,
 * where y is up. The surface is drawn behind the curve: its outline, and the edges of its folds.
 *
 * \tparam TriangleMesh a model of `FaceListGraph`
 *
 * \param out the stream
 * \param curve the curve
 * \param mesh the surface, closed and in the same coordinates
 *
 * \return whether writing succeeded
 */
template <typename Traits, typename TriangleMesh>
bool write_svg(std::ostream& out,
               const Volume_filling_curves::Curve_network_3<Traits>& curve,
               const TriangleMesh& mesh)
{
  namespace internal = Volume_filling_curves::internal;
  const internal::Curve_view view(curve, internal::triangle_soup(mesh));
  const internal::Stroke_layers layers(curve, view);
  internal::Svg_painter(layers, view.width(), out)(curve, view);
  return out.good();
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_IO_WRITE_SVG_H
