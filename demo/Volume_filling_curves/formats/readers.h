// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_READERS_H
#define VFC_READERS_H

#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Polyline_conventions.h>

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace vfc {

using CGAL::Volume_filling_curves::Junctions;
using CGAL::Volume_filling_curves::internal::Curve_draft;
using CGAL::Volume_filling_curves::internal::Defect_list;

// Readers of formats beyond those of the library: each takes the text of a file, and returns its
// vertices, edges and defects.

// PLY, in ASCII or binary, with the elements vertex and edge, the latter with the properties
// vertex1 and vertex2. Vertices whose property pinned is not 0 are pinned. Without edges and faces
// there is one closed curve through all vertices.
Curve_draft read_ply(std::string_view text, Junctions junctions);

// VTK's XML format for polygonal data, with the same conventions, in any encoding except LZ4 and
// LZMA.
Curve_draft read_vtp(std::string_view text, Junctions junctions);

// Geomview's VECT, the format of KnotPlot, plCurve and Ridgerunner.
Curve_draft read_vect(std::string_view text, Junctions junctions);

// Lists of points, one per line, without information whether they are closed.
Curve_draft read_point_list(std::string_view text, Junctions junctions);

// The backbones of the Protein Data Bank, in Angstrom: in its old format, and in mmCIF.
Curve_draft read_pdb(std::string_view text, Junctions junctions);
Curve_draft read_mmcif(std::string_view text, Junctions junctions);

// The faces of a surface, as indices of vertices; strips are cut into triangles.
using Polygons = std::vector<std::vector<std::size_t>>;

// Adds the triangles of a strip: each point forms one with its two predecessors, and every second
// one is reversed. Triangles with a repeated corner, which only continue the strip elsewhere, are
// left out.
inline void add_strip(const std::vector<std::size_t>& strip, Polygons& polygons)
{
  for(std::size_t i = 2; i < strip.size(); ++i) {
    const std::size_t odd = i % 2;
    const std::size_t a = strip[i - 2 + odd], b = strip[i - 1 - odd], c = strip[i];
    if(a != b && b != c && c != a) polygons.push_back({a, b, c});
  }
}

// Read the vertices and the faces of a surface: in a PLY file the list vertex_indices, or
// vertex_index, of the elements face and tristrips, in which -1 ends a strip of triangles.
Curve_draft read_off_surface(std::string_view text, Polygons& polygons);
Curve_draft read_ply_surface(std::string_view text, Polygons& polygons);
Curve_draft read_vtp_surface(std::string_view text, Polygons& polygons);

// Returns the values that a PLY file has for a property of the vertices, if it has that property.
std::optional<std::vector<double>> read_ply_column(std::string_view text,
                                                   std::string_view property,
                                                   Defect_list& defects);

} // namespace vfc

#endif // VFC_READERS_H
