// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_READ_MESH_FILE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_READ_MESH_FILE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/IO/Mesh_file.h>
#include <CGAL/Volume_filling_curves/internal/IO/Mesh_text_diagnosis.h>
#include <CGAL/Volume_filling_curves/internal/IO/whole_files.h>

#include <CGAL/IO/polygon_soup_io.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Reads points and faces through CGAL, in whatever formats its version and configuration know (VTP
// only with VTK), and cuts faces with more than three corners into triangles: a fan, which is right
// for convex ones; for others the check for self-intersections has the last word.

inline std::string lower_case_extension(const std::string& filename)
{
  std::string extension = std::filesystem::path(filename).extension().string();
  for(char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

inline bool is_mesh_extension(const std::string& extension)
{
  for(const char* known : {".off", ".obj", ".ply", ".stl", ".ts", ".wrl", ".vtp"})
    if(extension == known) return true;
  return false;
}

// The lines that are wrong, in the formats for which we can tell.
inline void diagnose_text(Mesh_file& file, const std::string& extension, const std::string& text)
{
  std::vector<Mesh_defect> reasons;
  if(extension == ".off") reasons = Mesh_text_diagnosis(text).of_off();
  if(extension == ".obj") reasons = Mesh_text_diagnosis(text).of_obj();
  for(Mesh_defect& reason : reasons) file.add(std::move(reason));
}

inline void diagnose_unreadable_mesh(Mesh_file& file,
                                     const std::string& extension,
                                     const std::string& text)
{
  diagnose_text(file, extension, text);
  if(file.has_error) return;
  const bool needs_library = extension == ".vtp";
  file.add({needs_library ? Mesh_defect_kind::UNKNOWN_FORMAT : Mesh_defect_kind::UNREADABLE_FILE,
            needs_library ? "reading .vtp files needs a program that was built with VTK"
                          : "this is no complete " + extension + " file of a surface"});
}

inline void add_faces(Mesh_file& file, const std::vector<std::vector<std::size_t>>& polygons)
{
  std::size_t cut = 0;
  Mesh_file::Indices cut_faces;
  for(std::size_t f = 0; f < polygons.size(); ++f) {
    const auto& polygon = polygons[f];
    if(polygon.size() < 3) {
      file.add({Mesh_defect_kind::DEGENERATE_FACE,
                "a face has fewer than three corners",
                0,
                {},
                {f + 1}});
      continue;
    }
    if(polygon.size() > 3 && ++cut <= Mesh_file::max_listed) cut_faces.push_back(f + 1);
    for(std::size_t i = 2; i < polygon.size(); ++i) {
      file.faces.push_back({polygon[0], polygon[i - 1], polygon[i]});
      file.face_numbers.push_back(f + 1);
    }
  }
  if(cut > 0)
    file.add({Mesh_defect_kind::POLYGONAL_FACE,
              std::to_string(cut) + " faces were cut into triangles",
              0,
              {},
              cut_faces});
}

inline bool has_bad_index(const Mesh_file& file)
{
  return std::any_of(file.faces.begin(), file.faces.end(), [&](const Mesh_file::Face& face) {
    return *std::max_element(face.begin(), face.end()) >= file.points.size();
  });
}

inline Mesh_file read_mesh_file(const std::string& filename)
{
  Mesh_file file;
  const std::string extension = lower_case_extension(filename);
  std::string text;
  if(!is_mesh_extension(extension)) {
    file.add({Mesh_defect_kind::UNKNOWN_FORMAT, "meshes are .off, .obj, .ply, .stl or .vtp files"});
    return file;
  }
  if(const std::error_code error = read_whole_file(filename, text)) {
    file.add({Mesh_defect_kind::UNREADABLE_FILE, error.message()});
    return file;
  }
  if(text.find_first_not_of(" \t\r\n") == std::string::npos) {
    file.add({Mesh_defect_kind::NO_GEOMETRY, "the file is empty"});
    return file;
  }
  std::vector<std::vector<std::size_t>> polygons;
  bool is_read = false;
  try {
    is_read = CGAL::IO::read_polygon_soup(filename, file.points, polygons,
                                          CGAL::parameters::verbose(false));
  } catch(const std::exception&) { // such as no memory for what a wrong header announces
  }
  if(is_read)
    add_faces(file, polygons);
  else
    diagnose_unreadable_mesh(file, extension, text);
  // CGAL lets some of these pass; without a line the checker will report them
  if(is_read && has_bad_index(file)) diagnose_text(file, extension, text);
  return file;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_READ_MESH_FILE_H
