// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/curve_pictures.h"

#include "pictures/Annotation.h"
#include "pictures/Picture_shader.h"
#include "pictures/Scene_raster.h"
#include "pictures/Stroke_layers.h"
#include "pictures/Svg_painter.h"
#include "pictures/Triangle_soup.h"
#include "pictures/cuts.h"
#include "pictures/surface_paths.h"
#include "pictures/svg_number.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <locale>
#include <optional>
#include <sstream>
#include <utility>

namespace vfc {
namespace {

constexpr double outline_width = 2.4; // of a cut surface, in picture units
constexpr double crease_width = 1.6;

double pixels_per_unit(const Picture_options& options)
{
  const auto [width, height] = options.pixels;
  return static_cast<double>((std::min)(width, height)) / Curve_view::picture_size;
}

// Returns the size in picture units; the shorter side is `Curve_view::picture_size`.
Eigen::Vector2d picture_size(const Picture_options& options)
{
  const Eigen::Vector2d pixels(static_cast<double>(options.pixels.width),
                               static_cast<double>(options.pixels.height));
  return pixels / pixels_per_unit(options);
}

// Content of a picture, whatever its format.
class Scene
{
public:
  Scene(const Curve& curve, const Mesh& mesh, const Picture_options& options)
      : m_curve(curve),
        m_options(options),
        m_values(edge_values(curve, options.coloring)),
        m_colors(options.coloring, m_values),
        m_view(curve,
               Triangle_soup(mesh),
               {options.direction, m_colors.scale().has_value(), options.cut, options.tube,
                picture_size(options)})
  {}

  const Tube_colors& colors() const { return m_colors; }
  void scale(double factor) { m_view.scale(factor); }

  std::optional<Half_space> kept() const
  {
    if(!m_options.cut) return std::nullopt;
    return side_kept(m_view.place(*m_options.cut));
  }

  Cut_surface surface() const
  {
    const std::optional<Half_space> half_space = kept();
    return half_space ? cut(m_view.surface(), *half_space) : Cut_surface{m_view.surface(), {}};
  }

  Drawn_curve whole_curve() const { return {m_curve, m_view, m_values}; }

  Drawn_curve kept_curve() const
  {
    Drawn_curve result = whole_curve();
    if(const std::optional<Half_space> half_space = kept()) cut(result, *half_space);
    return result;
  }

  // Returns labels and legend. \pre the scene has not been scaled
  Annotation annotation() const
  {
    Annotation result;
    const Eigen::Vector2d size = picture_size(m_options);
    if(m_options.has_labels) result = node_labels(kept_curve(), size);
    if(!m_colors.scale()) return result;
    const Annotation scale = legend(*m_colors.scale(), m_options.coloring, size);
    result.boxes.insert(result.boxes.end(), scale.boxes.begin(), scale.boxes.end());
    result.texts.insert(result.texts.end(), scale.texts.begin(), scale.texts.end());
    return result;
  }

private:
  const Curve& m_curve;
  const Picture_options& m_options;
  const Edge_values m_values;
  const Tube_colors m_colors;
  Curve_view m_view;
};

// Surface as SVG. All of it is behind the strands, except for the creases on the viewer's side and
// the outline of the section.
class Svg_surface
{
public:
  explicit Svg_surface(const Cut_surface& surface)
      : m_silhouette(silhouette_path(surface.soup)), m_creases(crease_paths(surface.soup))
  {
    Directed_edges rim;
    for(const auto& [v, w] : surface.rim) rim.insert({v, w});
    m_rim = loops_path(std::move(rim), surface.soup.points);
  }

  void write_back(std::ostream& out) const
  {
    if(!m_silhouette.empty())
      out << "<path fill=\"#e9eef4\" stroke=\"#9fb0c4\" stroke-linejoin=\"round\" d=\""
          << m_silhouette << "\"/>\n";
    write_creases(m_creases.back, "#cbd6e2", out);
    if(!m_rim.empty())
      out << "<path fill=\"#f4f6f9\" fill-rule=\"evenodd\" d=\"" << m_rim << "\"/>\n";
  }

  void write_front(std::ostream& out) const
  {
    write_creases(m_creases.front, "#7d93ad", out);
    if(!m_rim.empty())
      out << "<path fill=\"none\" stroke=\"#465870\" stroke-linejoin=\"round\" stroke-width=\""
          << svg_number(outline_width) << "\" d=\"" << m_rim << "\"/>\n";
  }

private:
  static void write_creases(const std::string& path, const char* color, std::ostream& out)
  {
    if(path.empty()) return;
    out << "<path fill=\"none\" stroke=\"" << color << "\" stroke-opacity=\"0.6\" stroke-width=\""
        << svg_number(crease_width) << "\" d=\"" << path << "\"/>\n";
  }

  std::string m_silhouette, m_rim;
  Crease_paths m_creases;
};

void add_rim(Scene_raster& raster, const Cut_surface& surface, double line_width)
{
  for(const auto& [v, w] : surface.rim)
    raster.add({surface.soup.points[v],
                surface.soup.points[w],
                line_width / 2,
                {0, 0},
                Scene_raster::Part::LINE});
}

} // namespace

std::string png_picture(const Curve& curve, const Mesh& mesh, const Picture_options& options)
{
  constexpr std::size_t samples_per_side = 2;
  const double samples_per_unit = samples_per_side * pixels_per_unit(options);
  Scene scene(curve, mesh, options);
  const Annotation annotation = scene.annotation();
  scene.scale(samples_per_unit);
  Scene_raster raster(samples_per_side * options.pixels.width,
                      samples_per_side * options.pixels.height);
  const Cut_surface surface = scene.surface();
  add_rim(raster, surface, outline_width * samples_per_unit);
  if(const std::optional<Half_space> kept = scene.kept()) raster.set_cut(*kept);
  const Drawn_curve drawn = scene.whole_curve();
  for(const Drawn_edge& edge : drawn.edges)
    raster.add(
        {drawn.points[edge.source], drawn.points[edge.target], drawn.width / 2, edge.values});
  raster.add_surface(surface.soup, corner_normals(surface.soup));
  Rgb_image image = Picture_shader(raster, scene.colors(), samples_per_side)();
  paint(annotation, 1 / pixels_per_unit(options), image);
  return to_png(image);
}

std::string svg_picture(const Curve& curve, const Mesh& mesh, const Picture_options& options)
{
  const Scene scene(curve, mesh, options);
  const Drawn_curve drawn = scene.kept_curve();
  const Stroke_layers layers(drawn, scene.colors().level_step());
  std::ostringstream out;
  out.imbue(std::locale::classic());
  const Eigen::Vector2d size = picture_size(options);
  const std::string width = svg_number(size.x()), height = svg_number(size.y());
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << ' ' << height
      << "\" width=\"" << options.pixels.width << "\" height=\"" << options.pixels.height
      << "\">\n<rect width=\"" << width << "\" height=\"" << height << "\" fill=\"#fff\"/>\n";
  const Svg_painter painter(layers, drawn, scene.colors(), out);
  const Svg_surface surface(scene.surface());
  painter.define_runs();
  surface.write_back(out);
  painter.paint();
  surface.write_front(out);
  const Annotation annotation = scene.annotation();
  if(!annotation.texts.empty()) write_svg(annotation, out);
  out << "</svg>\n";
  return out.str();
}

} // namespace vfc
