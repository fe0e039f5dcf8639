// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/fingerprint_pictures.h"

#include "pictures/Annotation.h"
#include "pictures/picture_colors.h"
#include "pictures/png_file.h"
#include "pictures/svg_number.h"

#include <algorithm>
#include <cstddef>
#include <locale>
#include <map>
#include <sstream>
#include <vector>

namespace vfc {
namespace {

using CGAL::Volume_filling_curves::Chain_identity;
using CGAL::Volume_filling_curves::Chain_section;

// Lengths in picture units: the triangle with numbers around it, and the legend.
constexpr double triangle_side = 600, triangle_margin = 60, digit_height = 13;
constexpr double legend_left = triangle_side + 2 * triangle_margin, legend_space = 180;

// Returns the knots of the fingerprint in the order of their colors: the unknot, then from the most
// frequent knot on.
std::vector<std::string> knots_of(const Chain_identity& identity)
{
  std::map<std::string, std::size_t> counts;
  for(const Chain_section& section : identity.fingerprint) ++counts[section.name];
  counts.erase("0_1");
  std::vector<std::string> knots;
  for(const auto& [name, count] : counts) knots.push_back(name);
  std::stable_sort(knots.begin(), knots.end(), [&](const std::string& a, const std::string& b) {
    return counts[a] > counts[b];
  });
  knots.insert(knots.begin(), "0_1");
  return knots;
}

Color color_of(const std::string& name, const std::vector<std::string>& knots)
{
  if(name == "0_1") return {226, 231, 237};
  if(name.empty()) return {120, 120, 120};
  const auto at = std::find(knots.begin(), knots.end(), name);
  return component_color(static_cast<std::size_t>(at - knots.begin()) - 1);
}

std::size_t last_node(const Chain_identity& identity)
{
  std::size_t last = 0;
  for(const Chain_section& section : identity.fingerprint) last = (std::max)(last, section.last);
  return last;
}

void add_cells(const Chain_identity& identity,
               const std::vector<std::string>& knots,
               Annotation& picture)
{
  std::vector<std::size_t> nodes; // the starts of sections, and the last node
  for(const Chain_section& section : identity.fingerprint)
    if(nodes.empty() || nodes.back() != section.first) nodes.push_back(section.first);
  nodes.push_back(last_node(identity));
  const auto at = [&](std::size_t node) {
    return triangle_margin + triangle_side * static_cast<double>(node) / double(nodes.back());
  };
  for(const Chain_section& section : identity.fingerprint) {
    const std::size_t next = *std::upper_bound(nodes.begin(), nodes.end(), section.first);
    const std::size_t previous = *(std::lower_bound(nodes.begin(), nodes.end(), section.last) - 1);
    const double x = at(section.first), y = at(previous);
    picture.boxes.push_back({x, y, at(next) - x, at(section.last) - y,
                             mix({255, 255, 255}, color_of(section.name, knots), section.share)});
  }
}

// Adds the numbers of the first and the last node, below the columns and beside the rows.
void add_numbers(const Chain_identity& identity, Annotation& picture)
{
  constexpr double end = triangle_margin + triangle_side;
  const std::string last = std::to_string(last_node(identity) + 1);
  picture.texts.push_back({"1", triangle_margin, end + 2 * digit_height, digit_height});
  picture.texts.push_back({last, end, end + 2 * digit_height, digit_height});
  picture.texts.push_back(
      {"1", triangle_margin - 2 * digit_height, triangle_margin + digit_height, digit_height});
  picture.texts.push_back({last, triangle_margin - 4 * digit_height, end, digit_height});
}

void add_legend(const std::vector<std::string>& knots, Annotation& picture)
{
  constexpr double spacing = 2 * digit_height;
  double y = triangle_margin;
  for(const std::string& name : knots) {
    picture.boxes.push_back({legend_left, y, digit_height, digit_height, color_of(name, knots)});
    picture.texts.push_back(
        {name.empty() ? "unnamed" : name, legend_left + spacing, y + digit_height, digit_height});
    y += spacing;
  }
}

Annotation fingerprint(const Chain_identity& identity)
{
  const std::vector<std::string> knots = knots_of(identity);
  Annotation picture;
  add_cells(identity, knots, picture);
  add_numbers(identity, picture);
  add_legend(knots, picture);
  return picture;
}

} // namespace

std::string svg_fingerprint(const Chain_identity& identity)
{
  const std::string width = svg_number(legend_left + legend_space);
  const std::string height = svg_number(legend_left);
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << ' ' << height
      << "\" width=\"" << width << "\" height=\"" << height << "\">\n<rect width=\"" << width
      << "\" height=\"" << height << "\" fill=\"#fff\"/>\n";
  write_svg(fingerprint(identity), out);
  out << "</svg>\n";
  return out.str();
}

std::string png_fingerprint(const Chain_identity& identity)
{
  constexpr std::size_t pixels_per_unit = 2, channels = 3;
  Rgb_image image;
  image.width = pixels_per_unit * static_cast<std::size_t>(legend_left + legend_space);
  image.height = pixels_per_unit * static_cast<std::size_t>(legend_left);
  image.bytes.assign(channels * image.width * image.height, 255);
  paint(fingerprint(identity), 1. / pixels_per_unit, image);
  return to_png(image);
}

} // namespace vfc
