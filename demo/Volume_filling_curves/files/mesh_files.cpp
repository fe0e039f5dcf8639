// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "files/mesh_files.h"

#include "formats/Ply_items.h"
#include "formats/Xml_scanner.h"
#include "meshes/examine_mesh.h"
#include "meshes/read_mesh_soup.h"
#include "session/Session.h"

#include <CGAL/Volume_filling_curves/internal/text/whole_files.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string_view>

namespace vfc {
namespace {

namespace files = CGAL::Volume_filling_curves::internal;

struct Obj_records
{
  bool has_lines = false, has_faces = false;
};

Obj_records records_of(const std::string& file)
{
  Obj_records records;
  std::ifstream lines(file);
  for(std::string line, keyword; std::getline(lines, line);) {
    std::istringstream words(line);
    if(!(words >> keyword)) continue;
    records.has_lines = records.has_lines || keyword == "l";
    records.has_faces = records.has_faces || keyword == "f";
  }
  return records;
}

// returns whether a PLY file has edges and no faces
bool is_ply_of_edges(const std::string& file)
{
  std::string text;
  if(files::read_whole_file(file, text)) return false;
  Defect_list defects; // for the reader to tell
  const Ply_items items(text, defects);
  const auto has = [&](std::string_view name) {
    const auto is_there = [&](const Ply_element& e) { return e.name == name && e.count > 0; };
    return std::any_of(items.elements().begin(), items.elements().end(), is_there);
  };
  return has("edge") && !has("face") && !has("tristrips");
}

// returns whether a VTP file has lines and neither polygons nor strips
bool is_vtp_of_lines(const std::string& file)
{
  std::string text;
  if(files::read_whole_file(file, text)) return false;
  Xml_scanner tags(text);
  while(tags.next_tag()) {
    if(tags.name() != "Piece") continue;
    const auto has = [&](std::string_view count) {
      return tags.attribute(count).find_first_of("123456789") != std::string_view::npos;
    };
    return has("NumberOfLines") && !has("NumberOfPolys") && !has("NumberOfStrips");
  }
  return false;
}

bool is_curve_file(const std::string& file)
{
  const std::string extension = lower_case_extension(file);
  if(extension == ".ply") return is_ply_of_edges(file);
  if(extension == ".vtp") return is_vtp_of_lines(file);
  const std::string polylines = ".polylines.txt";
  const bool has_polylines =
      file.size() > polylines.size() &&
      file.compare(file.size() - polylines.size(), polylines.size(), polylines) == 0;
  return has_polylines || (extension == ".obj" && records_of(file).has_lines);
}

// Expected contents of a file, and the remedy.
std::string expected(const Mesh_findings& findings)
{
  if(findings.is_mendable()) return "a valid mesh; use vfc repair, or fill with --repair";
  if(is_curve_file(findings.file())) return "a valid mesh; it holds a curve";
  return "a valid mesh";
}

} // namespace

Mesh_and_defects read_mesh_and_defects(const std::string& file)
{
  Mesh_findings findings(file);
  Mesh_and_defects result = examine(read_mesh_soup(file, findings), findings);
  result.defects = findings.list();
  return result;
}

void accept(Session& session, const Mesh_findings& findings)
{
  if(findings.has_error()) throw Input_error(findings.summary(), expected(findings));
  print_defects(session.console(), findings.list());
}

Mesh_and_defects read_mesh(Session& session, const std::string& file)
{
  Mesh_findings findings(file);
  Mesh_and_defects result = examine(read_mesh_soup(file, findings), findings);
  accept(session, findings);
  session.end_stage("reading");
  return result;
}

bool is_mesh_file(const std::string& file)
{
  const std::string extension = lower_case_extension(file);
  if(extension != ".obj") return is_mesh_extension(extension) && !is_curve_file(file);
  const Obj_records records = records_of(file);
  return records.has_faces && !records.has_lines;
}

} // namespace vfc
