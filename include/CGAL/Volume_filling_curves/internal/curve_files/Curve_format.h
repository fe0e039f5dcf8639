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
#include <CGAL/Volume_filling_curves/internal/curve_files/Obj_curve_reader.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Polyline_scanner.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/curve_writers.h>
#include <CGAL/Volume_filling_curves/internal/polylines/Curve_paths.h>
#include <CGAL/Volume_filling_curves/internal/text/whole_files.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Polyline_conventions.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Format of curve files: its extension in lower case, its reader and its writer.
struct Curve_format
{
  std::string_view extension;
  Curve_draft (*read)(std::string_view text, Junctions junctions);
  std::string (*write)(const Curve_paths& curve); // null if the format is only read
  bool has_numbered_nodes = false; // whether nodes are always in the order of their numbers
};

inline Curve_draft read_obj(std::string_view text, Junctions)
{
  return Obj_curve_reader(text).run();
}

// Reader of CGAL's `.polylines.txt` files: one polyline `n x0 y0 z0 x1 y1 z1 ...` per line. The
// numbers may continue on the next lines, as in readers based on stream operators. Linear time.
class Polylines_txt_reader
{
public:
  Polylines_txt_reader(std::string_view text, Junctions junctions) : m_file(text, junctions) {}

  Curve_draft run()
  {
    Text_scanner& words = m_file.words();
    for(; !words.is_at_end(); words.next_record()) {
      const std::string_view word = words.next_word();
      if(!word.empty()) read_polyline(word);
    }
    return m_file.finish();
  }

private:
  void read_polyline(std::string_view count_word)
  {
    const std::size_t line = m_file.words().line();
    std::size_t count = 0;
    if(!parse_integer(count_word, count))
      return m_file.add_defect(Curve_defect_kind::UNPARSABLE_NUMBER,
                               quoted(count_word) + " is not a number of points");
    std::vector<Polyline_scanner::Point> points;
    Polyline_scanner::Point point;
    for(; points.size() < count && m_file.read_point(point); point = {}) points.push_back(point);
    const std::string announcement =
        "the polyline of line " + std::to_string(line) +
        (points.size() < count
             ? " announces " + std::to_string(count) + " points, the file ends after " +
                   std::to_string(points.size())
             : " has more than the " + std::to_string(count) + " points that it announces");
    if(points.size() < count || !m_file.words().next_word().empty())
      m_file.add_defect(Curve_defect_kind::WRONG_POINT_COUNT, announcement);
    m_file.polylines().add(points, line);
  }

  Polyline_scanner m_file;
};

inline Curve_draft read_polylines_txt(std::string_view text, Junctions junctions)
{
  return Polylines_txt_reader(text, junctions).run();
}

// Table of the library's formats. A program adds formats by its own table, whose rows may be of a
// derived class.
inline constexpr Curve_format curve_formats[] = {
    {".obj", read_obj, to_obj, true}, {".polylines.txt", read_polylines_txt, to_polylines_txt}};

// Returns the first format of a table with whose extension, in upper or lower case, the file name
// ends, or null.
template <typename Formats>
auto find_format(const Formats& formats, const std::string& filename)
    -> decltype(&*std::begin(formats))
{
  const auto is_same_letter = [](char small, char c) {
    return small == (c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  };
  for(const auto& format : formats) {
    const std::string_view extension = format.extension;
    if(filename.size() >= extension.size() &&
       std::equal(extension.begin(), extension.end(),
                  filename.end() - static_cast<std::ptrdiff_t>(extension.size()), is_same_letter))
      return &format;
  }
  return nullptr;
}

// Returns the extensions of the formats for which `is_listed` holds, such as ".a, .b or .c".
template <typename Formats, typename Is_listed>
std::string extensions_text(const Formats& formats, const Is_listed& is_listed)
{
  std::string text, last;
  for(const auto& format : formats) {
    if(!is_listed(format)) continue;
    if(!last.empty()) text += (text.empty() ? "" : ", ") + last;
    last = format.extension;
  }
  return text.empty() ? last : text + " or " + last;
}

// Reads a file of one of the formats, and closes or opens its components at the user's request. The
// draft of an unreadable file has an error.
template <typename Formats>
Curve_draft read_curve_draft(const Formats& formats,
                             const std::string& filename,
                             Junctions junctions,
                             std::optional<Closure> closure)
{
  Curve_draft draft;
  std::string text;
  const auto* const format = find_format(formats, filename);
  draft.is_complete = false;
  if(format == nullptr)
    draft.defects.add(
        {Curve_defect_kind::UNKNOWN_FORMAT,
         "curves are " + extensions_text(formats, [](const auto&) { return true; }) + " files"});
  else if(const std::error_code error = read_whole_file(filename, text))
    draft.defects.add({Curve_defect_kind::UNREADABLE_FILE, error.message()});
  else
    draft = format->read(text, junctions);
  if(closure && draft.is_complete) {
    draft.says_what_is_closed = true;
    Component_closure(draft).apply(*closure);
  }
  return draft;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_CURVE_FORMAT_H
