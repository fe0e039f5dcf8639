// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/writers.h"

#include <CGAL/Volume_filling_curves/internal/curve_files/curve_writers.h>
#include <CGAL/Volume_filling_curves/internal/text/number_text.h>

#include <cstddef>
#include <vector>

namespace vfc {
namespace {

namespace files = CGAL::Volume_filling_curves::internal;

// Whether each node is pinned; empty if none is, and then files have no such column.
std::vector<bool> are_pinned(const Curve_paths& curve)
{
  std::vector<bool> is_pinned(curve.pinned.empty() ? 0 : curve.points.size(), false);
  for(const std::size_t v : curve.pinned) is_pinned[v] = true;
  return is_pinned;
}

// An array of VTK's XML files, with one item in a line.
template <typename AppendItem>
void append_array(std::string& text,
                  const std::string& type_and_name,
                  std::size_t size,
                  const AppendItem& append_item)
{
  text += "<DataArray type=" + type_and_name + " format=\"ascii\">\n";
  for(std::size_t i = 0; i < size; ++i) {
    append_item(i);
    text += '\n';
  }
  text += "</DataArray>\n";
}

void append_point_data(std::string& text, const Curve_paths& curve, const Node_columns& columns)
{
  const std::vector<bool> is_pinned = are_pinned(curve);
  text += "<PointData>\n";
  for(const Node_column& column : columns)
    append_array(
        text,
        (column.has_integers ? "\"Int64\" Name=\"" : "\"Float64\" Name=\"") + column.name + '"',
        column.values.size(), [&](std::size_t v) { files::append_number(text, column.values[v]); });
  if(!is_pinned.empty())
    append_array(text, "\"UInt8\" Name=\"pinned\"", is_pinned.size(),
                 [&](std::size_t v) { text += is_pinned[v] ? '1' : '0'; });
  text += "</PointData>\n";
}

} // namespace

// The Stanford polygon format with the element `edge` instead of faces, as in its first
// description (Turk 1994).
std::string to_ply(const Curve_paths& curve, const Node_columns& columns)
{
  const std::vector<bool> is_pinned = are_pinned(curve);
  std::size_t number_of_edges = 0;
  for(const auto& path : curve.paths) number_of_edges += path.size() - 1;
  std::string text = "ply\nformat ascii 1.0\nelement vertex " +
                     std::to_string(curve.points.size()) +
                     "\nproperty double x\nproperty double y\nproperty double z\n";
  for(const Node_column& column : columns)
    text += (column.has_integers ? "property int " : "property double ") + column.name + '\n';
  if(!is_pinned.empty()) text += "property uchar pinned\n";
  text += "element edge " + std::to_string(number_of_edges) +
          "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  for(std::size_t v = 0; v < curve.points.size(); ++v) {
    std::string line;
    files::append(line, curve.points[v]);
    for(const Node_column& column : columns) files::append_number(line += ' ', column.values[v]);
    if(!is_pinned.empty()) line += is_pinned[v] ? " 1" : " 0";
    text.append(line, 1, std::string::npos).push_back('\n'); // without the first blank
  }
  for(const auto& path : curve.paths)
    for(std::size_t i = 1; i < path.size(); ++i)
      text += std::to_string(path[i - 1]) + ' ' + std::to_string(path[i]) + '\n';
  return text;
}

// The data of polygons in VTK's XML format, with a polyline for each path.
std::string to_vtp(const Curve_paths& curve, const Node_columns& columns)
{
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<PolyData>\n<Piece NumberOfPoints=\"" +
      std::to_string(curve.points.size()) + "\" NumberOfVerts=\"0\" NumberOfLines=\"" +
      std::to_string(curve.paths.size()) + "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n";
  append_point_data(text, curve, columns);
  text += "<Points>\n";
  append_array(text, "\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", curve.points.size(),
               [&](std::size_t v) { files::append(text, curve.points[v]); });
  text += "</Points>\n<Lines>\n";
  append_array(text, "\"Int64\" Name=\"connectivity\"", curve.paths.size(), [&](std::size_t i) {
    for(const std::size_t v : curve.paths[i]) text += ' ' + std::to_string(v);
  });
  std::size_t end = 0;
  append_array(text, "\"Int64\" Name=\"offsets\"", curve.paths.size(),
               [&](std::size_t i) { text += std::to_string(end += curve.paths[i].size()); });
  return text + "</Lines>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

// Geomview's format: the numbers of paths, points and colors; for each path its number of points,
// negative if it is closed; for each path its number of colors, 0; then all points.
std::string to_vect(const Curve_paths& curve)
{
  std::string counts, points;
  std::size_t number_of_points = 0;
  for(const auto& path : curve.paths) {
    const bool is_closed = path.size() > 1 && path.front() == path.back();
    const std::size_t n = path.size() - (is_closed ? 1 : 0);
    counts += (is_closed ? "-" : "") + std::to_string(n) + '\n';
    for(std::size_t i = 0; i < n; ++i) files::append_line(points, curve.points[path[i]]);
    number_of_points += n;
  }
  std::string text = "VECT\n" + std::to_string(curve.paths.size()) + ' ' +
                     std::to_string(number_of_points) + " 0\n" + counts;
  for(std::size_t i = 0; i < curve.paths.size(); ++i) text += "0\n";
  return text + points;
}

// Each path ends with an empty line; a closed one repeats its first point.
std::string to_point_list(const Curve_paths& curve)
{
  std::string text;
  for(const auto& path : curve.paths) {
    for(const std::size_t v : path) files::append_line(text, curve.points[v]);
    text += '\n';
  }
  return text;
}

} // namespace vfc
