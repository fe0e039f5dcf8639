// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_IO_VERTEX_VALUES_H
#define CGAL_VOLUME_FILLING_CURVES_IO_VERTEX_VALUES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/IO/Mesh_defect.h>
#include <CGAL/Volume_filling_curves/internal/IO/Ply_vertex_property.h>
#include <CGAL/Volume_filling_curves/internal/IO/read_mesh_file.h>
#include <CGAL/Volume_filling_curves/internal/IO/whole_files.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// One number per line; the first line may be a header. Blank lines and comments do not count.
inline void read_csv_column(const std::string& text,
                            std::vector<double>& values,
                            std::vector<std::size_t>& lines,
                            std::vector<Mesh_defect>& defects)
{
  Text_scanner scanner(text);
  for(bool is_first = true; !scanner.is_at_end(); scanner.next_record()) {
    std::string_view word = scanner.next_word();
    if(word.empty()) continue;
    if(word.back() == ',' || word.back() == ';') word.remove_suffix(1);
    double value = 0;
    const bool is_number = parse_number(word, value) && scanner.next_word().empty();
    if(is_number) {
      values.push_back(value);
      lines.push_back(scanner.line());
    } else if(!is_first) {
      defects.push_back({Mesh_defect_kind::UNPARSABLE_NUMBER,
                         quoted(word) + " is not the only number of its line", scanner.line()});
    }
    is_first = false;
  }
}

inline void check_vertex_values(const std::vector<double>& values,
                                const std::vector<std::size_t>& lines,
                                std::size_t number_of_vertices,
                                std::vector<Mesh_defect>& defects)
{
  for(std::size_t v = 0; v < values.size(); ++v)
    if(!(values[v] > 0) || !std::isfinite(values[v]))
      defects.push_back({Mesh_defect_kind::BAD_VALUE,
                         "a value is not positive and finite",
                         v < lines.size() ? lines[v] : 0,
                         {v + 1}});
  if(values.size() != number_of_vertices)
    defects.push_back({Mesh_defect_kind::WRONG_VALUE_COUNT,
                       std::to_string(values.size()) + " values for " +
                           std::to_string(number_of_vertices) + " vertices"});
}

} // namespace internal
} // namespace Volume_filling_curves

namespace IO {

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief reads one positive number per vertex of a mesh, for example a thickness, and lists what is
 * wrong.
 *
 * A `.ply` file has the numbers in a vertex property of type `float` or `double`. Any other file is
 * read as text with one number per line; the first line may be a header. Linear time.
 *
 * \param filename the name of the file
 * \param number_of_vertices how many numbers there have to be: the number of vertices in the file of
 * the mesh
 * \param values receives the numbers in the order of the file; they do not change if there is an error
 * \param defects receives all errors
 * \param property the name of the property in a `.ply` file
 *
 * \return whether there is no error
 */
inline bool read_vertex_values(const std::string& filename,
                               std::size_t number_of_vertices,
                               std::vector<double>& values,
                               std::vector<Volume_filling_curves::Mesh_defect>& defects,
                               const std::string& property = "thickness")
{
  using Volume_filling_curves::Mesh_defect_kind;
  namespace internal = Volume_filling_curves::internal;
  defects.clear();
  std::string text;
  if(const std::error_code error = internal::read_whole_file(filename, text)) {
    defects.push_back({Mesh_defect_kind::UNREADABLE_FILE, error.message()});
    return false;
  }
  std::vector<double> read;
  std::vector<std::size_t> lines;
  if(internal::lower_case_extension(filename) == ".ply") {
    internal::Ply_vertex_property ply(text, property);
    if(!ply.read(read, defects)) return false;
    for(std::size_t v = 0; v < read.size(); ++v) lines.push_back(ply.line(v));
  } else {
    internal::read_csv_column(text, read, lines, defects);
  }
  if(defects.empty()) internal::check_vertex_values(read, lines, number_of_vertices, defects);
  if(!defects.empty()) return false;
  values = read;
  return true;
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_IO_VERTEX_VALUES_H
