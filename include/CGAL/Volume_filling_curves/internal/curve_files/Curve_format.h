// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_CURVE_FORMAT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_CURVE_FORMAT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve_files/Component_closure.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Node_columns.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Obj_curve_reader.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Pdb_reader.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Ply_curve_reader.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Point_list_reader.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Polylines_txt_reader.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Vect_reader.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Vtp_reader.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/curve_writers.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/node_value_writers.h>
#include <CGAL/Volume_filling_curves/internal/polylines/Curve_paths.h>
#include <CGAL/Volume_filling_curves/internal/text/whole_files.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Node_values.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Polyline_conventions.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The formats of curve files. The first end of the file's name that fits decides, in upper or lower
// case; a new format is a new line of the table.
struct Curve_format
{
  // how errors name them
  static constexpr const char* extensions =
      ".obj, .polylines.txt, .ply, .vtp, .vect, .xyz, .txt, .dat or .pdb";
  static constexpr const char* written_extensions =
      ".obj, .polylines.txt, .ply, .vtp, .vect, .xyz, .txt or .dat";

  using Read = Curve_draft (*)(std::string_view text, Junctions junctions);
  using Write = std::string (*)(const Curve_paths& curve);
  using Write_with_values = std::string (*)(const Curve_paths& curve, const Node_columns& columns);

  std::string_view extension;
  Read read;
  Write write;
  Write_with_values write_with_values = nullptr; // in place of `write`
  bool has_numbered_nodes = false; // the nodes stand in the order of their numbers, come what may

  bool is_written() const { return write != nullptr || write_with_values != nullptr; }

  // \pre the format is written
  template <typename Network>
  std::string text_of(const Network& curve, const Node_values& values) const
  {
    const Curve_paths paths(curve);
    return write != nullptr ? write(paths) : write_with_values(paths, node_columns(curve, values));
  }

  // returns null if the format is unknown
  static const Curve_format* of(const std::string& filename);
};

inline Curve_draft read_obj(std::string_view text, Junctions)
{
  return Obj_curve_reader(text).run();
}

inline Curve_draft read_polylines_txt(std::string_view text, Junctions junctions)
{
  return Polylines_txt_reader(text, junctions).run();
}

inline Curve_draft read_vect(std::string_view text, Junctions junctions)
{
  return Vect_reader(text, junctions).run();
}

inline Curve_draft read_ply(std::string_view text, Junctions)
{
  return Ply_curve_reader(text).run();
}

inline Curve_draft read_vtp(std::string_view text, Junctions)
{
  return Vtp_reader(text).run();
}

inline Curve_draft read_pdb(std::string_view text, Junctions junctions)
{
  return Pdb_reader(text, junctions).run();
}

inline Curve_draft read_point_list(std::string_view text, Junctions junctions)
{
  return Point_list_reader(text, junctions).run();
}

inline const Curve_format* Curve_format::of(const std::string& filename)
{
  static constexpr Curve_format formats[] = {
      {".obj", read_obj, to_obj, nullptr, true},
      {".polylines.txt", read_polylines_txt, to_polylines_txt},
      {".ply", read_ply, nullptr, to_ply, true},
      {".vtp", read_vtp, nullptr, to_vtp, true},
      {".vect", read_vect, to_vect},
      {".xyz", read_point_list, to_point_list},
      {".txt", read_point_list, to_point_list},
      {".dat", read_point_list, to_point_list},
      {".pdb", read_pdb, nullptr}};
  const auto is_same_letter = [](char small, char c) {
    return small == (c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  };
  for(const Curve_format& format : formats) {
    const std::size_t length = format.extension.size();
    if(filename.size() >= length &&
       std::equal(format.extension.begin(), format.extension.end(),
                  filename.end() - std::ptrdiff_t(length), is_same_letter))
      return &format;
  }
  return nullptr;
}

// Closes or opens the components of a file, if the user says so.
inline Curve_draft with_closure(Curve_draft file, std::optional<Closure> closure)
{
  if(!closure || !file.is_complete) return file;
  file.says_what_is_closed = true;
  Component_closure(file).apply(*closure);
  return file;
}

// Reads a file of a format, which is null if it is unknown. A file that cannot be read gives a
// draft with an error.
inline Curve_draft read_curve_draft(const std::string& filename,
                                    const Curve_format* format,
                                    Junctions junctions,
                                    std::optional<Closure> closure)
{
  Curve_draft nothing;
  nothing.is_complete = false;
  std::string text;
  if(format == nullptr)
    nothing.defects.add({Curve_defect_kind::UNKNOWN_FORMAT,
                         std::string("curves are ") + Curve_format::extensions + " files"});
  else if(const std::error_code error = read_whole_file(filename, text))
    nothing.defects.add({Curve_defect_kind::UNREADABLE_FILE, error.message()});
  else
    return with_closure(format->read(text, junctions), closure);
  return nothing;
}

// Likewise a file of the format that its name stands for.
inline Curve_draft read_curve_draft(const std::string& filename,
                                    Junctions junctions,
                                    std::optional<Closure> closure)
{
  return read_curve_draft(filename, Curve_format::of(filename), junctions, closure);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_CURVE_FORMAT_H
