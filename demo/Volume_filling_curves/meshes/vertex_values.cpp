// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/vertex_values.h"

#include "formats/readers.h"
#include "meshes/read_mesh_soup.h"
#include "options/counted.h"
#include "options/numbers.h"

#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>

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

bool parse_cell(const std::string& cell, double& value)
{
  return parse(cell, value);
}

bool parse_cell(const std::string& cell, std::array<double, 3>& value)
{
  return parse_vector(cell, value);
}

std::string demand(double)
{
  return " is not one finite number";
}

std::string demand(const std::array<double, 3>&)
{
  return " is not three finite numbers";
}

// Reads a value of a line each; the first line that is not empty may be a header.
template <typename Value>
void read_csv(std::istream& in,
              std::vector<Value>& values,
              std::vector<std::size_t>& lines,
              Mesh_findings& findings)
{
  std::size_t line = 0;
  bool is_first = true;
  for(std::string text; std::getline(in, text);) {
    ++line;
    const std::string cell = cell_of(text);
    if(cell.empty()) continue;
    Value value{};
    if(parse_cell(cell, value)) {
      values.push_back(value);
      lines.push_back(line);
    } else if(!is_first) {
      findings.add_error("unparsable number",
                         CGAL::Volume_filling_curves::internal::quoted(cell) + demand(value),
                         {line});
    }
    is_first = false;
  }
}

void check_count(std::size_t number_of_values,
                 std::size_t number_of_vertices,
                 Mesh_findings& findings)
{
  if(number_of_values != number_of_vertices)
    findings.add_error("wrong value count", counted(number_of_values, "value") + " for " +
                                                counted(number_of_vertices, "vertex", "vertices"));
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
  check_count(values.size(), number_of_vertices, findings);
}

void check_vectors(const std::vector<std::array<double, 3>>& vectors,
                   std::size_t number_of_vertices,
                   Mesh_findings& findings)
{
  for(std::size_t v = 0; v < vectors.size(); ++v)
    for(const double x : vectors[v])
      if(!std::isfinite(x)) findings.add_error("bad value", "a vector is not finite", {0, {v + 1}});
  check_count(vectors.size(), number_of_vertices, findings);
}

std::vector<double> ply_column(const std::string& text,
                               const std::string& property,
                               Mesh_findings& findings)
{
  Defect_list defects;
  const std::optional<std::vector<double>> values = read_ply_column(text, property, defects);
  add_errors(defects, findings);
  if(!values && !defects.has_error())
    findings.add_error("missing property",
                       "the vertices have no property '" + property + "' that is a number");
  return values.value_or(std::vector<double>());
}

// Three columns as the rows that they stand for.
std::vector<std::array<double, 3>> rows(const std::array<std::vector<double>, 3>& columns)
{
  std::vector<std::array<double, 3>> rows;
  for(std::size_t v = 0; v < columns[0].size(); ++v)
    rows.push_back({columns[0][v], columns[1][v], columns[2][v]});
  return rows;
}

} // namespace

bool parse_vector(const std::string& text, std::array<double, 3>& vector)
{
  std::string words = text;
  std::replace_if(
      words.begin(), words.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
  std::istringstream in(words);
  std::string word;
  for(double& x : vector)
    if(!(in >> word) || !parse(word, x)) return false;
  return !(in >> word);
}

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
    values = ply_column(std::string(std::istreambuf_iterator<char>(in), {}), property, findings);
  else
    read_csv(in, values, lines, findings);
  if(!findings.has_error()) check_values(values, lines, number_of_vertices, findings);
  return values;
}

std::vector<std::array<double, 3>> read_vertex_vectors(const std::string& file,
                                                       const std::array<std::string, 3>& properties,
                                                       std::size_t number_of_vertices,
                                                       Mesh_findings& findings)
{
  std::vector<std::array<double, 3>> vectors;
  std::vector<std::size_t> lines;
  std::ifstream in(file, std::ios::binary);
  if(!in) {
    findings.add_error("unreadable file", "the file cannot be opened");
    return vectors;
  }
  if(lower_case_extension(file) == ".ply") {
    const std::string text(std::istreambuf_iterator<char>(in), {});
    std::array<std::vector<double>, 3> columns;
    for(std::size_t k = 0; k < 3 && !findings.has_error(); ++k)
      columns[k] = ply_column(text, properties[k], findings);
    if(!findings.has_error()) vectors = rows(columns);
  } else
    read_csv(in, vectors, lines, findings);
  if(!findings.has_error()) check_vectors(vectors, number_of_vertices, findings);
  return vectors;
}

} // namespace vfc
