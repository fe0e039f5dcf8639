// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/read_mesh_soup.h"

#include "options/numbers.h"

#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>
#include <CGAL/Volume_filling_curves/internal/text/whole_files.h>

#include <CGAL/IO/polygon_soup_io.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace vfc {
namespace {

namespace files = CGAL::Volume_filling_curves::internal;

// Replaces backslashes at the ends of continued lines by blanks; all else keeps its position.
// Blanks may follow: CGAL 6 continues such lines, too, and an assertion fails if they are empty.
std::string with_continued_lines(std::string text)
{
  constexpr std::string_view blanks(" \t\r\v\f\0", 6);
  // from the last one on, since backslashes may follow one another
  for(std::size_t end = text.size(), i; end > 0 && (i = text.rfind('\\', end - 1)) < end; end = i) {
    const std::size_t rest = (std::min)(text.find_first_not_of(blanks, i + 1), text.size());
    if(rest < text.size() && text[rest] != '\n') continue;
    std::fill(text.begin() + static_cast<std::ptrdiff_t>(i),
              text.begin() + static_cast<std::ptrdiff_t>((std::min)(rest + 1, text.size())), ' ');
  }
  return text;
}

// CGAL's reader stops after the line that it does not understand.
void read_obj(const std::string& text, Mesh_soup& soup, Polygons& polygons, Mesh_findings& findings)
{
  std::istringstream in(with_continued_lines(text));
  if(CGAL::IO::read_OBJ(in, soup.points, polygons) || in.eof()) return; // bad indices show later
  in.clear();
  const auto end = static_cast<std::size_t>(in.tellg());
  const std::size_t line_end = text.find_last_not_of('\n', end - 1);
  const std::size_t before = text.find_last_of('\n', line_end);
  const std::size_t start = before == std::string::npos ? 0 : before + 1;
  findings.add_error("unreadable file",
                     "this line does not belong in a surface: " +
                         files::quoted(std::string_view(text).substr(start, line_end + 1 - start)),
                     {1 + static_cast<std::size_t>(std::count(
                              text.begin(), text.begin() + std::ptrdiff_t(start), '\n'))});
}

// Takes the contents of a file with the faces of a surface.
void take(const Curve_draft& file, Mesh_soup& soup, Mesh_findings& findings)
{
  add_errors(file.defects, findings);
  for(const auto& p : file.points) soup.points.emplace_back(p[0], p[1], p[2]);
}

// STL files, and those of other formats that CGAL's version knows.
void read_with_cgal(const std::string& file,
                    Mesh_soup& soup,
                    Polygons& polygons,
                    Mesh_findings& findings)
{
  bool is_read = false;
  try {
    is_read =
        CGAL::IO::read_polygon_soup(file, soup.points, polygons, CGAL::parameters::verbose(false));
  } catch(const std::exception&) { // such as no memory for what a header announces
  }
  if(!is_read)
    findings.add_error("unreadable file", "this is not a complete " + lower_case_extension(file) +
                                              " file of a surface");
}

void cut_into_triangles(const Polygons& polygons, Mesh_soup& soup, Mesh_findings& findings)
{
  std::vector<std::size_t> cut;
  for(std::size_t f = 0; f < polygons.size(); ++f) {
    const auto& polygon = polygons[f];
    if(polygon.size() < 3)
      findings.add_error("degenerate face", "a face has fewer than three corners",
                         {0, {}, {f + 1}});
    if(polygon.size() > 3) cut.push_back(f + 1);
    for(std::size_t i = 2; i < polygon.size(); ++i) {
      soup.faces.push_back({polygon[0], polygon[i - 1], polygon[i]});
      soup.face_numbers.push_back(f + 1);
    }
  }
  if(!cut.empty())
    findings.add_warning("polygonal face",
                         counted(cut.size(), "face was", "faces were") + " cut into triangles",
                         {0, {}, cut});
}

// \throws std::system_error
std::string read_text(const std::string& file)
{
  std::string text;
  if(const auto error = CGAL::Volume_filling_curves::internal::read_whole_file(file, text))
    throw std::system_error(error);
  return text;
}

} // namespace

void add_errors(const Defect_list& defects, Mesh_findings& findings)
{
  using Kind = CGAL::Volume_filling_curves::Curve_defect_kind;
  for(const auto& defect : defects.listed())
    findings.add_error(defect.kind == Kind::WRONG_POINT_COUNT ? "truncated file"
                                                              : to_string(defect.kind),
                       defect.message, {defect.line, defect.nodes});
}

std::string lower_case_extension(const std::string& file)
{
  std::string extension = std::filesystem::path(file).extension().string();
  for(char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

bool is_mesh_extension(const std::string& extension)
{
  for(const char* known : {".off", ".obj", ".ply", ".stl", ".ts", ".wrl", ".vtp"})
    if(extension == known) return true;
  return false;
}

Mesh_soup read_mesh_soup(const std::string& file, Mesh_findings& findings)
{
  Mesh_soup soup;
  Polygons polygons;
  const std::string extension = lower_case_extension(file);
  if(!is_mesh_extension(extension)) {
    findings.add_error("unknown format",
                       extension == ".wkt"
                           ? "polygons are no mesh; fill, check, measure and draw take them"
                           : "meshes are .off, .obj, .ply, .stl or .vtp files");
    return soup;
  }
  try {
    const std::string text = read_text(file);
    if(text.find_first_not_of(" \t\r\n") == std::string::npos)
      findings.add_error("no geometry", "the file is empty");
    else if(extension == ".obj")
      read_obj(text, soup, polygons, findings);
    else if(extension == ".off")
      take(read_off_surface(text, polygons), soup, findings);
    else if(extension == ".ply")
      take(read_ply_surface(text, polygons), soup, findings);
    else if(extension == ".vtp")
      take(read_vtp_surface(text, polygons), soup, findings);
    else
      read_with_cgal(file, soup, polygons, findings);
  } catch(const std::system_error& error) {
    findings.add_error("unreadable file", error.code().message());
  }
  if(!findings.has_error()) cut_into_triangles(polygons, soup, findings);
  return soup;
}

} // namespace vfc
