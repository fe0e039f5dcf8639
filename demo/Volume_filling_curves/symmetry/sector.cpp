// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "symmetry/sector.h"

#include "meshes/mesh_size.h"
#include "options/numbers.h"
#include "repair/combined_shells.h"
#include "repair/repair_steps.h"

#include <CGAL/Volume_filling_curves/internal/filling/filling_shape.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/distance.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;
namespace PMP = CGAL::Polygon_mesh_processing;

using Point = Symmetry::Point;

// In units of the thickness.
constexpr double min_depth = 1.5; // of a port, below the surface
constexpr double max_asymmetry = 0.01;

// Beyond these sizes CGAL's corefinement divides by products that are 0 or infinite.
constexpr double min_size = 1e-50, max_size = 1e50;

// The distance that an arc keeps from the cuts, and therefore from the whole boundary of a sector.
// With it and that of the cuts from the planes, strands of different images are as far apart as
// required. Strands settle about 0.6 r from a wall, and few come nearer than 0.3 r. The images of
// the arc are nearer to the mesh than the arc by as much as that is asymmetric.
double wall_distance_of_arc(const Filling_parameters& parameters,
                            double thickness,
                            double asymmetry)
{
  constexpr double of_strands = 0.3; // in units of the thickness
  const bool is_required = curves::internal::shape_goal(parameters).is_given();
  const double of_wall = parameters.wall_distance > 0 ? parameters.wall_distance + asymmetry : 0;
  return (std::max)(is_required ? of_strands * thickness : 0, of_wall);
}

// The distance of the cuts from the planes of the symmetry. For a strand distance of 1.6 r, the
// cuts of a box and a torus were moved from 0.2 r to 0.35, 0.5 and 0.7 r: 85, 83, 81 and 77 % of
// the volume were within r.
double distance_of_cuts(const Filling_parameters& parameters, double thickness, double of_arc)
{
  constexpr double least = 0.2; // in units of the thickness
  constexpr double rounding = 1 + 1e-6;
  const double distance = curves::internal::shape_goal(parameters).strand_distance.at(thickness);
  return (std::max)(least * thickness, rounding * distance / 2 - of_arc);
}

Input_error fault(const std::string& file, const std::string& text, const std::string& expected)
{
  return Input_error({Defect("symmetry", true, file, {}, text)}, expected);
}

void require_moderate_size(const Mesh& mesh, const std::string& file)
{
  const double size = diagonal(mesh);
  if(!(size > min_size && size < max_size))
    throw fault(file, "the mesh has the size " + to_text(size),
                "a mesh of a size from 1e-50 to 1e50, as --symmetry needs");
}

// Returns how far apart the mesh and its first image are.
double asymmetry_of(const Mesh& mesh,
                    const Symmetry& symmetry,
                    double thickness,
                    const std::string& file)
{
  std::vector<Point> images;
  for(const Mesh::Vertex_index v : mesh.vertices())
    images.push_back(symmetry.image(mesh.point(v), 1));
  const double distance = PMP::max_distance_to_triangle_mesh<CGAL::Sequential_tag>(images, mesh);
  if(distance > max_asymmetry * thickness)
    throw fault(file, "the mesh and its image are up to " + to_text(distance) + " apart",
                "a mesh that --symmetry maps onto itself within r / 100");
  return distance;
}

// Returns a box with one side in the plane that contains the part of another box on the positive
// side of the plane. PMP::clip() would instantiate corefinement three more times.
Mesh box_above(const Kernel::Plane_3& plane, const CGAL::Bbox_3& box)
{
  const Point low(box.xmin(), box.ymin(), box.zmin()), high(box.xmax(), box.ymax(), box.zmax());
  const Point middle = CGAL::midpoint(low, high), foot = plane.projection(middle);
  const auto scaled = [](const Symmetry::Vector& v, double length) {
    return length / std::sqrt(v.squared_length()) * v;
  };
  const double size = std::sqrt(CGAL::squared_distance(low, high)); // twice what is needed
  const double depth = size + std::sqrt(CGAL::squared_distance(middle, foot));
  const Symmetry::Vector u = scaled(plane.base1(), size), v = scaled(plane.base2(), size),
                         w = scaled(plane.orthogonal_vector(), depth);
  Mesh result;
  std::vector<Mesh::Vertex_index> corners;
  for(const Point& p : {foot, foot + w})
    for(const auto& [s, t] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
      corners.push_back(result.add_vertex(p + s * u + t * v));
  const auto add_quad = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    result.add_face(corners[a], corners[b], corners[c]);
    result.add_face(corners[a], corners[c], corners[d]);
  };
  add_quad(3, 2, 1, 0);
  add_quad(4, 5, 6, 7);
  for(std::size_t k = 0; k < 4; ++k) add_quad(k, (k + 1) % 4, (k + 1) % 4 + 4, k + 4);
  return result;
}

void cut(Mesh& mesh, const Symmetry& symmetry, double distance, const std::string& file)
{
  Work_watch watch;
  for(const Symmetry::Side& side : symmetry.sides()) {
    const Kernel::Plane_3 plane(side.origin + distance * side.normal, side.normal);
    std::optional<Mesh> rest = intersection(mesh, box_above(plane, PMP::bbox(mesh)), watch);
    if(!rest || rest->is_empty())
      throw fault(file, "the mesh cannot be cut into sectors",
                  "a mesh that the planes of --symmetry cross");
    mesh = std::move(*rest);
  }
  // of a plane through a vertex or along an edge, after rounding
  merge_near_vertices(mesh, watch);
  remove_flat_faces(mesh, watch);
}

double half_distance(const Point& p, const Point& q)
{
  return std::sqrt(CGAL::squared_distance(p, q)) / 2;
}

// Searches the plane, or half-plane, where a sector begins for places to enter it.
class Port_search
{
public:
  Port_search(const Domain& domain, const Symmetry& symmetry, double wall_distance)
      : m_symmetry(symmetry)
  {
    const CGAL::Bbox_3 box = domain.bbox();
    const double size = std::sqrt(CGAL::squared_distance(
        Point(box.xmin(), box.ymin(), box.zmin()), Point(box.xmax(), box.ymax(), box.zmax())));
    const Point middle = CGAL::midpoint(Point(box.xmin(), box.ymin(), box.zmin()),
                                        Point(box.xmax(), box.ymax(), box.zmax()));
    const Point origin = symmetry.point_of_cut(0, 0);
    const double s0 = (middle - origin) * (symmetry.point_of_cut(1, 0) - origin);
    const double t0 = (middle - origin) * (symmetry.point_of_cut(0, 1) - origin);
    for(int i = 0; i <= cells; ++i)
      for(int j = 0; j <= cells; ++j) {
        const double s = s0 + size * (static_cast<double>(i) / cells - 0.5);
        const double t = t0 + size * (static_cast<double>(j) / cells - 0.5);
        const Point p = symmetry.point_of_cut(s, t);
        if((!symmetry.is_mirror() && s <= 0) || !domain.is_inside(p)) continue;
        double depth = domain.distance(p) - wall_distance;
        if(!symmetry.is_mirror()) depth = (std::min)(depth, half_distance(p, symmetry.image(p, 1)));
        m_places.push_back({p, depth});
      }
  }

  // The deepest place, and for a mirror image another one that is deep and far from it.
  std::vector<Point> operator()(double depth_of_port) const
  {
    std::vector<Point> ports;
    for(std::size_t k = 0; k < (m_symmetry.is_mirror() ? 2u : 1u); ++k) {
      double best = depth_of_port;
      const Place* found = nullptr;
      for(const Place& place : m_places) {
        double depth = place.depth;
        for(const Point& p : ports) depth = (std::min)(depth, half_distance(p, place.point));
        if(!(depth > best)) continue;
        best = depth;
        found = &place;
      }
      if(!found) return {};
      ports.push_back(found->point);
    }
    return ports;
  }

private:
  static constexpr int cells = 200; // along the diagonal of the box

  struct Place
  {
    Point point;
    double depth;
  };

  const Symmetry& m_symmetry;
  std::vector<Place> m_places;
};

Ports ports_of(const Symmetry& symmetry, const std::vector<Point>& places, double distance)
{
  Ports ports;
  const auto add = [&](const Point& p, const Symmetry::Vector& n) {
    ports.push_back({p + distance * n, {n.x(), n.y(), n.z()}});
  };
  const auto sides = symmetry.sides();
  for(const Point& p : places) add(p, sides.front().normal);
  if(!symmetry.is_mirror()) add(symmetry.image(places[0], 1), sides.back().normal);
  return ports;
}

} // namespace

Sector sector_of(const Mesh& mesh,
                 const Domain& domain,
                 const Symmetry& symmetry,
                 const Filling_parameters& parameters,
                 const std::string& file)
{
  const double thickness =
      (std::max)(parameters.thickness, curves::internal::min_thickness_for(parameters));
  require_moderate_size(mesh, file);
  const double asymmetry = static_cast<double>(symmetry.order() / 2) * // of all images
                           asymmetry_of(mesh, symmetry, thickness, file);
  const double wall_distance = wall_distance_of_arc(parameters, thickness, asymmetry);
  const double distance = distance_of_cuts(parameters, thickness, wall_distance);
  const double depth = min_depth * thickness;
  const auto places = Port_search(domain, symmetry, parameters.wall_distance)(depth);
  if(places.empty())
    throw fault(file, "strands have no room where --symmetry cuts the mesh",
                "a mesh that --symmetry cuts where points lie " +
                    to_text(depth + parameters.wall_distance) + " below the surface");
  Sector sector{mesh, ports_of(symmetry, places, distance), wall_distance};
  cut(sector.mesh, symmetry, distance, file);
  return sector;
}

} // namespace vfc
