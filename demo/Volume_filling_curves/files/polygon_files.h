// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_POLYGON_FILES_H
#define VFC_POLYGON_FILES_H

#include "files/mesh_files.h"

#include <CGAL/Volume_filling_curves/internal/domain/Polygon_domain_3.h>

#include <CGAL/Polygon_with_holes_2.h>

#include <optional>
#include <string>
#include <vector>

namespace vfc {

// Domains in the plane, from files of polygons as well-known text (WKT).
using Planar_domain = CGAL::Volume_filling_curves::Polygon_domain_3<>;

using Polygon = CGAL::Polygon_with_holes_2<Kernel>;

struct Polygons_and_defects
{
  std::vector<Polygon> polygons;
  std::optional<Planar_domain> domain; // none if there is an error
  Defects defects;
};

// returns whether a file has the extension of polygons
bool is_polygon_file(const std::string& file);

// Reads the polygons of all records, POLYGON or MULTIPOLYGON.
Polygons_and_defects read_polygons_and_defects(const std::string& file);

// Reads polygons and accepts them: there is a domain. \throws Input_error
Polygons_and_defects read_polygons(Session& session, const std::string& file);

// Calls a function with the domain of a file: polygons, or the inside of a mesh.
// \throws Input_error
template <typename Function>
auto with_domain(Session& session, const std::string& file, const Function& function)
{
  if(is_polygon_file(file)) return function(*read_polygons(session, file).domain);
  return function(Domain(read_mesh(session, file).mesh, examined));
}

} // namespace vfc

#endif // VFC_POLYGON_FILES_H
