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
    append_gaps(i, j, runs[key].gaps);
  }
  for(auto& entry : runs) m_runs.push_back(std::move(entry.second));
}

// Strokes run a little into the next run, light ones farther than dark ones, so that no seam shows;
// less than the gap, so that nothing else is covered.
void Svg_painter::append_overlaps(std::size_t first,
                                  std::size_t last,
                                  double extent,
                                  std::string& path) const
{
  const auto append = [&](const Vector& inside, const Vector& end, const Vector& outside) {
    const auto towards = [&](const Vector& p) {
      const double length = (p - end).head<2>().norm();
      const double share = (std::min)(0.5, Stroke_layers::gap_share * m_width / length);
      return svg_coordinates(end + extent * share * (p - end));
    };
    path += 'M' + towards(inside) + 'L' + svg_coordinates(end) + 'L' + towards(outside);
  };
  const Stroke_piece &front = m_pieces[first], &back = m_pieces[last - 1];
  if(front.previous != Stroke_piece::none)
    append(front.target, front.source, m_pieces[front.previous].source);
  if(back.next != Stroke_piece::none) append(back.source, back.target, m_pieces[back.next].target);
}

// The white stroke is needed only where something passes below.
void Svg_painter::append_gaps(std::size_t first, std::size_t last, std::string& path) const
{
  for(std::size_t i = first, j = first; i < last; i = j) {
    for(j = i + 1; j < last && m_pieces[j].is_over == m_pieces[i].is_over;) ++j;
    if(!m_pieces[i].is_over) continue;
    path += 'M';
    append_points(i, j, path);
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

// An open end is a dot, and so is a junction, in the highest of the layers that meet there.
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
    m_runs.push_back({key, 'M' + svg_coordinates(p) + "h0", "", ""});
  }
  std::stable_sort(m_runs.begin(), m_runs.end(),
                   [](const Run& a, const Run& b) { return a.key < b.key; });
}

void Svg_painter::paint_layer(std::size_t first, std::size_t last) const
{
  std::string gaps;
  for(std::size_t i = first; i < last; ++i) gaps += m_runs[i].gaps;
  if(!gaps.empty())
    m_out << "<path stroke=\"#fff\" stroke-width=\""
          << svg_number((1 + 2 * Stroke_layers::gap_share) * m_width) << "\" d=\"" << gaps
          << "\"/>\n";
  stroke(first, last, m_width, Tint::DARK);
  stroke(first, last, 0.78 * m_width, Tint::PLAIN);
  stroke(first, last, 0.26 * m_width, Tint::LIGHT);
}

// Draws all runs of a layer with one width.
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
