// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/vertex_values.h"

#include "meshes/mesh_text.h"
#include "meshes/read_mesh_soup.h"
#include "options/numbers.h"

#include <CGAL/IO/read_ply_points.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

namespace vfc {
namespace {

// returns what is left of a line of a CSV file: without separators, blanks and comments
std::string cell_of(std::string line)
{
  const char* const ignored = " \t\r,;";
  line.erase(0, line.find_first_not_of(ignored));
  line.erase(line.find_last_not_of(ignored) + 1);
  return line.empty() || line[0] == '#' ? std::string() : line;
}

void read_csv(std::istream& in,
              std::vector<double>& values,
              std::vector<std::size_t>& lines,
              Mesh_findings& findings)
{
  std::size_t line = 0;
  bool is_first = true;
  for(std::string text; std::getline(in, text);) {
    ++line;
    const std::string cell = cell_of(text);
    if(cell.empty()) continue;
    double value = 0;
    if(parse(cell, value)) {
      values.push_back(value);
      lines.push_back(line);
    } else if(!is_first) {
      findings.add_error("unparsable number", in_quotes(cell) + " is not one finite number",
                         {line});
    }
    is_first = false;
  }
}

// CGAL takes a property that is missing for zero.
bool has_property(const std::string& text, const std::string& property)
{
  const std::string header = text.substr(0, text.find("end_header"));
  for(const char* type : {"float", "float32", "double", "float64"})
    if(header.find(std::string("property ") + type + ' ' + property + '\n') != std::string::npos ||
       header.find(std::string("property ") + type + ' ' + property + '\r') != std::string::npos)
      return true;
  return false;
}

void read_ply(const std::string& text,
              const std::string& property,
              std::vector<double>& values,
              Mesh_findings& findings)
{
  for(const Text_problem& problem : problems_of_ply(text))
    findings.add_error(problem.kind, problem.message, {problem.line});
  if(findings.has_error()) return;
  if(!has_property(text, property))
    return findings.add_error("missing property", "the vertices have no property '" + property +
                                                      "' of type float or double");
  std::istringstream in(text);
  auto reader = std::make_pair(CGAL::Identity_property_map<double>(),
                               CGAL::IO::PLY_property<double>(property.c_str()));
  if(!CGAL::IO::read_PLY_with_properties<double>(in, std::back_inserter(values), std::move(reader)))
    findings.add_error("unreadable file", "this is no complete PLY file");
}

void check_values(const std::vector<double>& values,
                  const std::vector<std::size_t>& lines,
                  std::size_t number_of_vertices,
                  Mesh_findings& findings)
{
  for(std::size_t v = 0; v < values.size(); ++v)
    if(!(values[v] > 0) || !std::isfinite(values[v]))
      findings.add_error("bad value", "a value is not positive and finite",
                         {v < lines.size() ? lines[v] : 0, {v + 1}});
  if(values.size() != number_of_vertices)
    findings.add_error("wrong value count", std::to_string(values.size()) + " values for " +
                                                std::to_string(number_of_vertices) + " vertices");
}

} // namespace

std::vector<double> read_vertex_values(const std::string& file,
                                       const std::string& property,
                                       std::size_t number_of_vertices,
                                       Mesh_findings& findings)
{
  std::vector<double> values;
  std::vector<std::size_t> lines; // of the values, if they have some
  std::ifstream in(file, std::ios::binary);
  if(!in) {
    findings.add_error("unreadable file", "the file cannot be opened");
    return values;
  }
  if(lower_case_extension(file) == ".ply")
    read_ply(std::string(std::istreambuf_iterator<char>(in), {}), property, values, findings);
  else
    read_csv(in, values, lines, findings);
  if(!findings.has_error()) check_values(values, lines, number_of_vertices, findings);
  return values;
}

} // namespace vfc
