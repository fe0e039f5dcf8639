// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_LIVE_FILLING_H
#define VFC_LIVE_FILLING_H

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/fill.h>

#include <CGAL/Surface_mesh.h>

#include <functional>
#include <string>
#include <vector>

namespace vfc_page {

namespace VFC = CGAL::Volume_filling_curves;

// What a user can choose, with lengths in the mesh's unit.
struct Filling_settings
{
  double thickness;   // in the middle of the mesh's box
  double bend_radius; // 0: none is required
  double ratio;       // of the thicknesses at the ends of the longest side of the mesh's box
};

// What a run calls while it lasts.
struct Filling_events
{
  std::function<void()> show;                           // after each change that can be seen
  std::function<void(const VFC::Run_progress&)> report; // every few milliseconds
  std::function<void(const VFC::Run_checkpoint&)> keep; // before each iteration
};

// The inside of a mesh, and the curve that fills it, which can be seen while it grows.
class Live_filling
{
public:
  using Curve = VFC::Curve_network_3<>;
  using Point = Curve::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  using Result = VFC::Filling_result<Point>;

  // \throws std::invalid_argument unless the mesh bounds a domain
  explicit Live_filling(const Mesh& mesh) : m_mesh(mesh), m_domain(mesh) {}

  // Fills the domain, by one thread.
  // \throws std::invalid_argument if the settings do not suit the domain
  void fill(const Filling_settings& settings, const Filling_events& events);

  // Has the curve of a run with these settings as it was in this state, and measures it.
  // \throws std::invalid_argument if the state is not that of such a run
  void restore(const Filling_settings& settings, const VFC::Run_state& state);

  const Mesh& mesh() const { return m_mesh; }
  CGAL::Bbox_3 box() const { return m_domain.bbox(); }
  const Curve& curve() const { return m_curve; }
  const Result& result() const { return m_result; }

  // The nodes of each strand in their order, also while the curve branches.
  std::vector<std::vector<Point>> strands() const;

  // The circles that the curve grew from, where the certificate begins.
  Curve start() const;
  std::string certificate() const { return m_certificate.bytes(); }

private:
  VFC::Filling_parameters<Point> parameters(const Filling_settings& settings);
  std::function<double(const Point&)> thickness_field(double thickness, double ratio) const;

  const Mesh m_mesh;
  const VFC::Triangle_mesh_domain_3<> m_domain;
  Curve m_curve;
  Result m_result;
  VFC::Isotopy_certificate m_certificate;
};

// Reads a closed surface from a file, and cuts its polygons into triangles.
// \throws std::invalid_argument unless there is one
Live_filling::Mesh read_surface(const std::string& file);

} // namespace vfc_page

#endif // VFC_LIVE_FILLING_H
