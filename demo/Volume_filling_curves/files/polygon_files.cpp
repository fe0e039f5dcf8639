// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "files/polygon_files.h"

#include "files/read_finite_file.h"
#include "meshes/read_mesh_soup.h"
#include "session/Session.h"

#include <CGAL/IO/WKT.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace vfc {
namespace {

struct Wkt_record
{
  std::string text; // in one line and in capitals, as CGAL's readers want it
  std::size_t line;
};

// Divides a text after the parenthesis that closes the first one.
std::vector<Wkt_record> wkt_records(const std::string& text)
{
  std::vector<Wkt_record> records(1, {"", 1});
  std::size_t line = 1, depth = 0;
  for(const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    const bool is_space = std::isspace(code) != 0;
    if(c == '\n') ++line;
    if(is_space && records.back().text.empty())
      records.back().line = line;
    else
      records.back().text += is_space ? ' ' : static_cast<char>(std::toupper(code));
    if(c == '(') ++depth;
    if(c == ')' && depth > 0 && --depth == 0) records.push_back({"", line});
  }
  if(records.back().text.empty()) records.pop_back();
  return records;
}

// CGAL's readers crash at rings without corners.
bool has_empty_ring(const std::string& text)
{
  if(text.find("EMPTY") != std::string::npos) return true;
  for(std::size_t k = text.find('('); k != std::string::npos; k = text.find('(', k + 1)) {
    const std::size_t next = text.find_first_not_of(' ', k + 1);
    if(next != std::string::npos && text[next] == ')') return true;
  }
  return false;
}

// Returns whether the record holds polygons, and adds them.
bool read_record(const Wkt_record& record, std::vector<Polygon>& polygons)
{
  if(has_empty_ring(record.text)) return false;
  std::istringstream in(record.text);
  std::vector<Polygon> found(1);
  const std::string multiple = "MULTIPOLYGON";
  const bool is_read = record.text.compare(0, multiple.size(), multiple) == 0
                           ? CGAL::IO::read_multi_polygon_WKT(in, found)
                           : CGAL::IO::read_polygon_WKT(in, found.front());
  polygons.insert(polygons.end(), found.begin(), found.end());
  return is_read && !found.empty() && !found.front().outer_boundary().is_empty();
}

Defect polygon_error(const std::string& kind,
                     const std::string& file,
                     std::size_t line,
                     const std::string& message)
{
  return {kind, true, file, {line}, message};
}

// The defect that the library has found, "kind: message".
Defect defect_of_polygons(const std::string& file, const std::string& what)
{
  const std::size_t colon = (std::min)(what.find(": "), what.size());
  return polygon_error(what.substr(0, colon), file, 0,
                       what.substr((std::min)(colon + 2, what.size())) +
                           "; corners, holes and polygons are counted from 0");
}

} // namespace

bool is_polygon_file(const std::string& file)
{
  return lower_case_extension(file) == ".wkt";
}

Polygons_and_defects read_polygons_and_defects(const std::string& file)
{
  Polygons_and_defects result;
  std::string text;
  if(const std::error_code code = read_finite_file(file, text)) {
    result.defects.push_back(polygon_error("unreadable file", file, 0, code.message()));
    return result;
  }
  for(const Wkt_record& record : wkt_records(text))
    if(!read_record(record, result.polygons))
      result.defects.push_back(
          polygon_error("syntax error", file, record.line,
                        "this is no POLYGON or MULTIPOLYGON with corners of two coordinates"));
  if(!result.defects.empty()) return result;
  try {
    result.domain.emplace(result.polygons);
  } catch(const std::invalid_argument& exception) {
    result.defects.push_back(defect_of_polygons(file, exception.what()));
  }
  return result;
}

Polygons_and_defects read_polygons(Session& session, const std::string& file)
{
  Polygons_and_defects read = read_polygons_and_defects(file);
  if(!read.domain) throw Input_error(std::move(read.defects), "a file of valid polygons");
  session.end_stage("reading");
  return read;
}

} // namespace vfc
