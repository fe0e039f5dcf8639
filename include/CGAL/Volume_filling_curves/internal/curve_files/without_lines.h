// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_WITHOUT_LINES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_WITHOUT_LINES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>

#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Says what a file is that lists vertices and lines, but has no lines: a surface, nothing, or one
// closed curve through all vertices. Takes the line of its first face, 0 if there is none, and its
// last line.
inline void take_without_lines(Curve_draft& file, std::size_t line_of_face, std::size_t last_line)
{
  if(line_of_face > 0)
    return file.defects.add(
        {Curve_defect_kind::FACES_ONLY, "there are faces but no lines", line_of_face});
  if(file.points.empty())
    return file.defects.add({Curve_defect_kind::NO_GEOMETRY, "there are no vertices", last_line});
  file.defects.add({Curve_defect_kind::NO_LINES,
                    "there are no lines; all vertices are taken for one closed curve", last_line});
  for(std::size_t v = 0; v < file.points.size(); ++v)
    file.add_edge(v, (v + 1) % file.points.size(), file.point_lines[0]);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_WITHOUT_LINES_H
