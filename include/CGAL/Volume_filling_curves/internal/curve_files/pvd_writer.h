// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_PVD_WRITER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_PVD_WRITER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/text/append_number.h>

#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// As an attribute of XML.
inline std::string in_xml(const std::string& text)
{
  std::string escaped;
  for(const char c : text)
    if(c == '&' || c == '<' || c == '"')
      escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : "&quot;";
    else
      escaped += c;
  return escaped;
}

// The list of frames, by which ParaView plays a film.
template <typename Frames>
std::string to_pvd(const Frames& frames)
{
  std::string text = "<?xml version=\"1.0\"?>\n"
                     "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
                     "<Collection>\n";
  for(const auto& frame : frames) {
    append_number(text += "<DataSet timestep=\"", frame.time);
    text += "\" part=\"0\" file=\"" + in_xml(frame.filename) + "\"/>\n";
  }
  return text + "</Collection>\n</VTKFile>\n";
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_PVD_WRITER_H
