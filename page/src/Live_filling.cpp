// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Live_filling.h"

#include "formats/readers.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace vfc_page {

namespace {

// Ends a run at once.
struct Filling_stopper : VFC::Default_curve_flow_visitor
{
  template <typename Flow>
  bool go_further(const Flow&)
  {
    return false;
  }
};

// Shows the curve after each iteration.
struct Filling_viewer : VFC::Default_curve_flow_visitor
{
  template <typename Flow>
  void on_start(const Flow&)
  {
    show();
  }

  template <typename Flow>
  void on_iteration(const Flow&)
  {
    show();
  }

  const std::function<void()>& show;
};

using vfc::Polygons;
using Points = std::vector<Live_filling::Point>;

// OFF files are read as the program reads them, which says what is wrong in which line and face.
void read_off(const std::string& file, Points& points, Polygons& polygons)
{
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  const vfc::Curve_draft surface = vfc::read_off_surface(text.str(), polygons);
  for(const VFC::Curve_defect& defect : surface.defects.listed()) {
    const std::string face =
        polygons.empty() ? "" : ", face " + std::to_string(polygons.size() - 1);
    throw std::invalid_argument("line " + std::to_string(defect.line) + face + ": " +
                                defect.message);
  }
  for(const auto& p : surface.points) points.emplace_back(p[0], p[1], p[2]);
}

// Numbers are from 0, as in the sentences of the library.
[[noreturn]] void refuse(const std::string& defect)
{
  throw std::invalid_argument(defect + "; use 'vfc repair'");
}

// \throws std::invalid_argument if a face has a vertex that does not exist
void check_vertices(const Polygons& polygons, std::size_t number_of_points)
{
  for(std::size_t f = 0; f < polygons.size(); ++f)
    for(const std::size_t v : polygons[f])
      if(v >= number_of_points)
        throw std::invalid_argument("face " + std::to_string(f) + " has vertex " +
                                    std::to_string(v) + ", but the file has " +
                                    std::to_string(number_of_points) +
                                    " vertices, numbered from 0");
}

// \throws std::invalid_argument if a face has no three corners, or has a corner twice, or if two
// faces have an edge in the same direction
void check_faces(const Polygons& polygons)
{
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> faces;
  for(std::size_t f = 0; f < polygons.size(); ++f) {
    std::vector<std::size_t> corners = polygons[f];
    if(corners.size() < 3) refuse("face " + std::to_string(f) + " has fewer than three corners");
    std::sort(corners.begin(), corners.end());
    const auto twice = std::adjacent_find(corners.begin(), corners.end());
    if(twice != corners.end())
      refuse("face " + std::to_string(f) + " has vertex " + std::to_string(*twice) + " twice");
    for(std::size_t i = 0; i < polygons[f].size(); ++i) {
      const std::size_t a = polygons[f][i], b = polygons[f][(i + 1) % polygons[f].size()];
      const auto [edge, is_new] = faces.emplace(std::pair(a, b), f);
      if(!is_new)
        refuse("faces " + std::to_string(edge->second) + " and " + std::to_string(f) +
               " have opposite orientations, or more than two faces meet in the edge from vertex " +
               std::to_string(a) + " to " + std::to_string(b));
    }
  }
}

} // namespace

Live_filling::Mesh read_surface(const std::string& file)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Points points;
  Polygons polygons;
  bool is_read = true;
  if(file.size() > 4 && file.substr(file.size() - 4) == ".off")
    read_off(file, points, polygons);
  else
    is_read = CGAL::IO::read_polygon_soup(file, points, polygons, CGAL::parameters::verbose(false));
  check_vertices(polygons, points.size()); // which OBJ files that are not read can lack
  if(!is_read || polygons.empty())
    throw std::invalid_argument("this is not a complete file of a surface");
  check_faces(polygons);
  std::vector<std::array<std::size_t, 3>> triangles;
  for(const auto& polygon : polygons)
    for(std::size_t i = 2; i < polygon.size(); ++i)
      triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
  if(!PMP::is_polygon_soup_a_polygon_mesh(triangles))
    refuse("parts of the surface meet in a vertex only");
  Live_filling::Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  return mesh;
}

void Live_filling::fill(const Filling_settings& settings, const Filling_events& events)
{
  VFC::Filling_parameters<Point> run = parameters(settings);
  run.progress = [&](const VFC::Run_progress& progress) {
    if(progress.stage == VFC::Run_stage::BRANCHING) events.show();
    events.report(progress);
    return true;
  };
  run.checkpoint = events.keep;
  m_curve = Curve();
  m_result = VFC::fill(m_curve, m_domain, run, Filling_viewer{{}, events.show});
}

void Live_filling::restore(const Filling_settings& settings, const VFC::Run_state& state)
{
  VFC::Filling_parameters<Point> run = parameters(settings);
  run.resume_from = &state;
  m_curve = Curve();
  m_result = VFC::fill(m_curve, m_domain, run, Filling_stopper());
}

VFC::Filling_parameters<Live_filling::Point> Live_filling::parameters(
    const Filling_settings& settings)
{
  VFC::Filling_parameters<Point> parameters;
  if(settings.ratio == 1)
    parameters.thickness = settings.thickness;
  else
    parameters.thickness_field = thickness_field(settings.thickness, settings.ratio);
  parameters.bend_radius = settings.bend_radius;
  parameters.round_bends = settings.bend_radius > 0;
  parameters.certificate = &m_certificate;
  return parameters;
}

// The thickness varies linearly, which takes no function that libraries compute differently, and is
// the given one in the middle.
std::function<double(const Live_filling::Point&)> Live_filling::thickness_field(double thickness,
                                                                                double ratio) const
{
  const CGAL::Bbox_3 box = m_domain.bbox();
  int axis = 0;
  for(int k = 1; k < 3; ++k)
    if((box.max)(k) - (box.min)(k) > (box.max)(axis) - (box.min)(axis)) axis = k;
  const double low = (box.min)(axis), side = (box.max)(axis)-low;
  return [=](const Point& p) {
    const double t = std::clamp((p[axis] - low) / side, 0., 1.);
    return 2 * thickness * ((1 - t) + t * ratio) / (1 + ratio);
  };
}

std::vector<std::vector<Live_filling::Point>> Live_filling::strands() const
{
  std::vector<std::vector<Point>> strands;
  std::vector<bool> is_seen(m_curve.number_of_nodes() + m_curve.number_of_removed_nodes());
  for(const std::size_t first : m_curve.nodes()) {
    if(is_seen[first]) continue;
    strands.emplace_back();
    std::size_t last = first, v = first;
    do {
      is_seen[v] = true;
      strands.back().push_back(m_curve.point(v));
      const std::size_t next = m_curve.neighbor(v, m_curve.neighbor(v, 1) == last ? 0 : 1);
      last = v;
      v = next;
    } while(v != first);
  }
  return strands;
}

Live_filling::Curve Live_filling::start() const
{
  return Curve(m_result.start);
}

} // namespace vfc_page
