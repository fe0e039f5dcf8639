// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "film/Film.h"

#include "formats/binary_numbers.h"
#include "pictures/Triangle_soup.h"
#include "pictures/picture_colors.h"
#include "pictures/strands.h"
#include "pictures/svg_number.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace vfc {
namespace {

using Json = nlohmann::ordered_json;

template <typename Points, typename Function>
Eigen::AlignedBox3d box_of(const Points& points, const Function& to_point)
{
  Eigen::AlignedBox3d box;
  for(const auto& p : points) box.extend(to_point(p));
  return box;
}

Json list(const Vector& p)
{
  return {p.x(), p.y(), p.z()};
}

} // namespace

Film::Film(const std::string& title, const Mesh& mesh)
{
  constexpr std::size_t colors = 8;
  m_json["title"] = title;
  for(std::size_t k = 0; k < colors; ++k) m_json["colors"].push_back(svg_color(component_color(k)));
  m_json["frames"] = Json::array();
  m_json["surface"] = nullptr;
  if(mesh.is_empty()) return;
  Triangle_soup soup(mesh);
  choose_coordinates(box_of(soup.points, [](const Vector& p) { return p; }));
  std::vector<float> coordinates;
  for(Vector& p : soup.points) {
    append(coordinates, p);
    p = (p - m_origin) / m_unit;
  }
  std::vector<std::uint32_t> triangles;
  for(const auto& triangle : soup.triangles)
    for(const std::size_t v : triangle) triangles.push_back(static_cast<std::uint32_t>(v));
  m_volume = soup.volume();
  m_json["surface"] = {{"points", base64(coordinates)}, {"triangles", base64(triangles)}};
}

void Film::add(std::size_t iteration, const Curve& curve)
{
  if(m_unit == 0) choose_coordinates(box_of(curve.points(), to_vector));
  Json strands = Json::array();
  std::vector<float> coordinates;
  for(const Strand& strand : strands_of(curve)) {
    std::vector<std::size_t> nodes;
    for(const std::size_t e : strand.edges) nodes.push_back(curve.source(e));
    if(!strand.is_closed) nodes.push_back(curve.target(strand.edges.back()));
    for(const std::size_t v : nodes) append(coordinates, to_vector(curve.point(v)));
    strands.push_back({nodes.size(), strand.is_closed ? 1 : 0, curve.component(nodes.front())});
  }
  const double length = CGAL::Volume_filling_curves::length(curve);
  m_longest = (std::max)(m_longest, m_unit > 0 ? length / m_unit : 0);
  m_json["frames"].push_back({{"iteration", iteration},
                              {"length", length},
                              {"nodes", curve.number_of_nodes()},
                              {"strands", std::move(strands)},
                              {"points", base64(coordinates)}});
}

void Film::choose_coordinates(const Eigen::AlignedBox3d& box)
{
  if(box.isEmpty()) return;
  const double diagonal = box.diagonal().norm();
  m_origin = box.center();
  m_unit = diagonal > 0 ? diagonal : 1;
}

void Film::append(std::vector<float>& coordinates, const Vector& p)
{
  const Vector q = (p - m_origin) / m_unit;
  m_box.extend(q);
  for(const double x : q) coordinates.push_back(static_cast<float>(x));
}

std::string Film::to_json(double tube) const
{
  Json json = m_json;
  json["tube"] = tube > 0 ? tube / m_unit : usual_tube();
  json["low"] = list(m_box.min());
  json["high"] = list(m_box.max());
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// A quarter of the distance of strands, which is sqrt(volume / length) in a filling, but at most
// 1.5 % of the diagonal. Without a surface the curve is taken to fill a tenth of the diagonal
// cubed.
double Film::usual_tube() const
{
  constexpr double radius_per_distance = 0.25, filled_share = 0.1, max_share = 0.015;
  const double diagonal = m_box.diagonal().norm();
  const double volume = m_volume > 0 ? m_volume : filled_share * std::pow(diagonal, 3);
  const double distance = m_longest > 0 ? std::sqrt(volume / m_longest) : diagonal;
  return (std::min)(radius_per_distance * distance, max_share * diagonal);
}

} // namespace vfc
