// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/vertex_values.h"

#include "formats/readers.h"
#include "meshes/read_mesh_soup.h"
#include "options/numbers.h"

#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>
#include <CGAL/Volume_filling_curves/internal/text/whole_files.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace vfc {
namespace {

namespace files = CGAL::Volume_filling_curves::internal;

// Numbers for each vertex of a mesh, and the lines where they stand, if they have some.
template <std::size_t N>
struct Rows
{
  std::vector<std::array<double, N>> values;
  std::vector<std::size_t> lines;
};

// Returns whether all of the text is so many finite numbers, with commas, semicolons or blanks
// between them.
template <std::size_t N>
bool parse_numbers(std::string text, std::array<double, N>& numbers)
{
  const auto is_separator = [](char c) { return c == ',' || c == ';'; };
  std::replace_if(text.begin(), text.end(), is_separator, ' ');
  std::istringstream in(text);
  std::string word;
  for(double& x : numbers)
    if(!(in >> word) || !parse(word, x)) return false;
  return !(in >> word);
}

// Reads a row of a line each; the first line that is not empty may be a header.
template <std::size_t N>
void read_csv(const std::string& text, Rows<N>& rows, Mesh_findings& findings)
{
  const char* const ignored = " \t\r,;";
  std::istringstream in(text);
  std::size_t line = 0;
  bool is_first = true;
  for(std::string cell; std::getline(in, cell);) {
    ++line;
    cell.erase(0, cell.find_first_not_of(ignored));
    cell.erase(cell.find_last_not_of(ignored) + 1);
    if(cell.empty() || cell[0] == '#') continue;
    std::array<double, N> row;
    if(parse_numbers(cell, row)) {
      rows.values.push_back(row);
      rows.lines.push_back(line);
    } else if(!is_first) {
      findings.add_error("unparsable number",
                         files::quoted(cell) + (N == 1 ? " is not one finite number"
                                                       : " is not three finite numbers"),
                         {line});
    }
    is_first = false;
  }
}

// Reads a row of so many vertex properties each.
template <std::size_t N>
void read_columns(const std::string& text,
                  const std::array<std::string, N>& properties,
                  Rows<N>& rows,
                  Mesh_findings& findings)
{
  for(std::size_t k = 0; k < N && !findings.has_error(); ++k) {
    Defect_list defects;
    const std::optional<std::vector<double>> column = read_ply_column(text, properties[k], defects);
    add_errors(defects, findings);
    if(!column && !defects.has_error())
      findings.add_error("missing property",
                         "the vertices have no property '" + properties[k] + "' that is a number");
    if(findings.has_error()) return;
    rows.values.resize(column->size());
    for(std::size_t v = 0; v < column->size(); ++v) rows.values[v][k] = (*column)[v];
  }
}

template <std::size_t N>
Rows<N> read_rows(const std::string& file,
                  const std::array<std::string, N>& properties,
                  std::size_t number_of_vertices,
                  Mesh_findings& findings)
{
  Rows<N> rows;
  std::string text;
  if(files::read_whole_file(file, text)) {
    findings.add_error("unreadable file", "the file cannot be opened");
  } else if(lower_case_extension(file) == ".ply") {
    read_columns(text, properties, rows, findings);
  } else {
    read_csv(text, rows, findings);
  }
  if(!findings.has_error() && rows.values.size() != number_of_vertices)
    findings.add_error("wrong value count", counted(rows.values.size(), "value") + " for " +
                                                counted(number_of_vertices, "vertex", "vertices"));
  return rows;
}

} // namespace

bool parse_vector(const std::string& text, std::array<double, 3>& vector)
{
  return parse_numbers(text, vector);
}

std::vector<double> read_vertex_values(const std::string& file,
                                       const std::string& property,
                                       std::size_t number_of_vertices,
                                       Mesh_findings& findings)
{
  std::vector<double> values;
  const Rows<1> rows = read_rows<1>(file, {property}, number_of_vertices, findings);
  for(const auto& [value] : rows.values) {
    const std::size_t v = values.size();
    if(!(value > 0) || !std::isfinite(value))
      findings.add_error("bad value", "a value is not positive and finite",
                         {v < rows.lines.size() ? rows.lines[v] : 0, {v + 1}});
    values.push_back(value);
  }
  return values;
}

std::vector<std::array<double, 3>> read_vertex_vectors(const std::string& file,
                                                       const std::array<std::string, 3>& properties,
                                                       std::size_t number_of_vertices,
                                                       Mesh_findings& findings)
{
  const Rows<3> rows = read_rows(file, properties, number_of_vertices, findings);
  for(std::size_t v = 0; v < rows.values.size(); ++v)
    for(const double x : rows.values[v])
      if(!std::isfinite(x)) findings.add_error("bad value", "a vector is not finite", {0, {v + 1}});
  return rows.values;
}

} // namespace vfc
