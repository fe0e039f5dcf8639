// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/Svg_painter.h"

#include "pictures/picture_colors.h"
#include "pictures/svg_number.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace vfc {
namespace {

constexpr std::size_t shades = 12;
constexpr double min_step = 0.7; // picture units between points of a path

// returns whether the point between two pieces can be left out of a path
bool is_straight(const Vector& pen, const Stroke_piece& piece, const Stroke_piece& next)
{
  const Eigen::Vector2d way = (next.target - pen).head<2>();
  const Eigen::Vector2d corner = (piece.target - pen).head<2>();
  const double length = way.norm();
  if(length < min_step) return true;
  const double offset = std::abs(way.x() * corner.y() - way.y() * corner.x()) / length;
  return offset < 0.02 && corner.dot(way) >= 0 && corner.norm() <= length && length < 60;
}

} // namespace

Svg_painter::Svg_painter(const Stroke_layers& layers,
                         const Drawn_curve& curve,
                         const Tube_colors& colors,
                         std::ostream& out)
    : m_pieces(layers.pieces()), m_curve(curve), m_colors(colors), m_width(curve.width), m_out(out)
{
  for(const Stroke_piece& piece : m_pieces) {
    m_back = (std::min)(m_back, piece.depth());
    m_front = (std::max)(m_front, piece.depth());
  }
  collect_runs();
  collect_gaps();
  collect_ends();
}

void Svg_painter::paint() const
{
  m_out << "<g fill=\"none\" stroke-linejoin=\"round\">\n";
  for(std::size_t first = 0, last = 0; first < m_runs.size(); first = last) {
    while(last < m_runs.size() && m_runs[last].key[0] == m_runs[first].key[0]) ++last;
    paint_layer(first, last);
  }
  m_out << "</g>\n";
}

void Svg_painter::define_runs() const
{
  m_out << "<defs>\n";
  for(std::size_t i = 0; i < m_runs.size(); ++i)
    m_out << "<path id=\"p" << i << "\" d=\"" << m_runs[i].path << "\"/><g id=\"q" << i
          << "\"><use href=\"#p" << i << "\"/><path d=\"" << m_runs[i].overlaps << "\"/></g>\n";
  m_out << "</defs>\n";
}

Svg_painter::Key Svg_painter::key_of(const Stroke_piece& piece) const
{
  const double range = m_front - m_back;
  const double share = range > 0 ? (piece.depth() - m_back) / range : 1;
  const auto shade = static_cast<std::size_t>(share * shades);
  return {piece.layer, m_colors.level(piece.value), (std::min)(shade, shades - 1), 0};
}

void Svg_painter::collect_runs()
{
  std::map<Key, Run> runs;
  for(std::size_t i = 0, j = 0; i < m_pieces.size(); i = j) {
    const Key key = key_of(m_pieces[i]);
    j = i + 1;
    while(j < m_pieces.size() && j == m_pieces[j - 1].next && key_of(m_pieces[j]) == key) ++j;
    runs[key].key = key;
    runs[key].path += 'M';
    append_points(i, j, runs[key].path);
    append_overlaps(i, j, 0.4, runs[key].path);
    append_overlaps(i, j, 1, runs[key].overlaps);
    for(const bool is_forward : {false, true}) {
      const std::size_t end = is_forward ? j - 1 : i;
      append_to_other_layer(end, is_forward, 0.4, &Run::path, runs);
      append_to_other_layer(end, is_forward, 1, &Run::overlaps, runs);
    }
  }
  for(auto& entry : runs) m_runs.push_back(std::move(entry.second));
}

// Strokes extend into the next run by little more than a pixel, light ones farther than dark ones,
// so that no seam shows. Round joins close the wedges outside bends, even where pieces have hardly
// any length in the picture.
void Svg_painter::append_overlaps(std::size_t first,
                                  std::size_t last,
                                  double extent,
                                  std::string& path) const
{
  constexpr double seam = 1.2; // picture units
  const auto append = [&](std::size_t inner, std::size_t outer, bool is_forward) {
    if(outer == Stroke_piece::none) return;
    std::vector<Vector> points = points_from(inner, !is_forward, seam);
    std::reverse(points.begin(), points.end());
    const std::vector<Vector> beyond = points_from(outer, is_forward, extent * seam);
    points.insert(points.end(), beyond.begin() + 1, beyond.end());
    for(std::size_t k = 0; k < points.size(); ++k)
      path += (k == 0 ? 'M' : 'L') + svg_coordinates(points[k]);
  };
  append(first, m_pieces[first].previous, false);
  append(last - 1, m_pieces[last - 1].next, true);
}

// Returns the points of a strand from piece i on, up to a length.
std::vector<Vector> Svg_painter::points_from(std::size_t i, bool is_forward, double length) const
{
  constexpr std::size_t max_points = 100; // since all may be at one point of the picture
  std::vector<Vector> points = {is_forward ? m_pieces[i].source : m_pieces[i].target};
  while(i != Stroke_piece::none && length > 0 && points.size() < max_points) {
    const Vector along = (is_forward ? m_pieces[i].target : m_pieces[i].source) - points.back();
    const double part = along.head<2>().norm();
    points.push_back(points.back() + (part > length ? length / part : 1) * along);
    length -= part;
    i = is_forward ? m_pieces[i].next : m_pieces[i].previous;
  }
  return points;
}

// Extends a strand that continues in another layer into that layer, in its colors, because the
// white stroke of the higher layer has cut into it. The extension is shorter than the gap, so it
// covers nothing else.
void Svg_painter::append_to_other_layer(std::size_t i,
                                        bool is_forward,
                                        double extent,
                                        std::string Run::*path,
                                        std::map<Key, Run>& runs) const
{
  constexpr int max_pieces = 100; // since all may have no length in the picture
  double length = extent * Stroke_layers::gap_share * m_width;
  std::size_t j = is_forward ? m_pieces[i].next : m_pieces[i].previous;
  if(j == Stroke_piece::none || m_pieces[j].layer == m_pieces[i].layer) return;
  for(int k = 0; j != Stroke_piece::none && length > 0 && k < max_pieces; ++k) {
    const Stroke_piece& piece = m_pieces[j];
    const Vector& from = is_forward ? piece.source : piece.target;
    const Vector along = (is_forward ? piece.target : piece.source) - from;
    const double part = along.head<2>().norm();
    Key key = key_of(piece);
    key[0] = m_pieces[i].layer;
    Run& run = runs[key];
    run.key = key;
    run.*path += 'M' + svg_coordinates(from) + 'L' +
                 svg_coordinates(from + (part > length ? length / part : 1) * along);
    length -= part;
    j = is_forward ? piece.next : piece.previous;
  }
}

// White strokes are needed only where something passes below. They do not end where the color
// changes: strokes that begin anew leave teeth at bends, and hairlines.
void Svg_painter::collect_gaps()
{
  const auto goes_on = [this](std::size_t i) {
    const std::size_t next = m_pieces[i].next;
    return next != Stroke_piece::none && m_pieces[next].is_over &&
           m_pieces[next].layer == m_pieces[i].layer;
  };
  for(std::size_t i = 0, j = 0; i < m_pieces.size(); i = j) {
    j = i + 1;
    if(!m_pieces[i].is_over) continue;
    while(j < m_pieces.size() && j == m_pieces[j - 1].next && goes_on(j - 1)) ++j;
    std::string& path = m_gaps[m_pieces[i].layer];
    path += 'M';
    append_points(i, j, path);
    if(goes_on(j - 1)) path += 'L' + svg_coordinates(m_pieces[m_pieces[j - 1].next].target);
  }
}

void Svg_painter::append_points(std::size_t first, std::size_t last, std::string& path) const
{
  Vector pen = m_pieces[first].source;
  path += svg_coordinates(pen);
  for(std::size_t i = first; i < last; ++i) {
    if(i + 1 < last && is_straight(pen, m_pieces[i], m_pieces[i + 1])) continue;
    pen = m_pieces[i].target;
    path += 'L' + svg_coordinates(pen);
  }
}

// Open ends and junctions are dots, in the highest of the layers that meet there.
void Svg_painter::collect_ends()
{
  std::map<std::array<double, 2>, std::size_t> piece_at;
  for(std::size_t i = 0; i < m_pieces.size(); ++i)
    for(const Vector& p : {m_pieces[i].source, m_pieces[i].target}) {
      std::size_t& highest = piece_at.insert({{p.x(), p.y()}, i}).first->second;
      if(m_pieces[i].layer > m_pieces[highest].layer) highest = i;
    }
  for(const std::size_t v : m_curve.ends) {
    const Vector& p = m_curve.points[v];
    const auto found = piece_at.find({p.x(), p.y()});
    if(found == piece_at.end()) continue;
    Key key = key_of(m_pieces[found->second]);
    key[3] = 1;
    m_runs.push_back({key, 'M' + svg_coordinates(p) + "h0", ""});
  }
  std::stable_sort(m_runs.begin(), m_runs.end(),
                   [](const Run& a, const Run& b) { return a.key < b.key; });
}

void Svg_painter::paint_layer(std::size_t first, std::size_t last) const
{
  const auto gaps = m_gaps.find(m_runs[first].key[0]);
  if(gaps != m_gaps.end())
    m_out << "<path stroke=\"#fff\" stroke-width=\""
          << svg_number((1 + 2 * Stroke_layers::gap_share) * m_width) << "\" d=\"" << gaps->second
          << "\"/>\n";
  stroke(first, last, m_width, Tint::DARK);
  stroke(first, last, 0.78 * m_width, Tint::PLAIN);
  stroke(first, last, 0.26 * m_width, Tint::LIGHT);
}

// Draws the runs of a layer with one width.
void Svg_painter::stroke(std::size_t first, std::size_t last, double width, Tint tint) const
{
  m_out << "<g stroke-width=\"" << svg_number(width) << "\">";
  for(std::size_t i = first; i < last; ++i)
    m_out << "<use href=\"#" << (tint == Tint::DARK ? 'p' : 'q') << i << "\" stroke=\""
          << color(m_runs[i].key, tint) << '"'
          << (m_runs[i].key[3] == 1 ? " stroke-linecap=\"round\"" : "") << "/>";
  m_out << "</g>\n";
}

std::string Svg_painter::color(const Key& key, Tint tint) const
{
  const double share = static_cast<double>(key[2]) / (shades - 1);
  Color result = m_colors.color(m_colors.value_of_level(key[1]), share);
  if(tint == Tint::DARK) result = mix(result, {20, 20, 40}, 0.45);
  if(tint == Tint::LIGHT) result = mix(result, {255, 255, 255}, 0.3 + 0.15 * share);
  return svg_color(result);
}

} // namespace vfc
