// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PAGE_VALUES_H
#define VFC_PAGE_VALUES_H

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/IO/curve_network.h>

#include <CGAL/Bbox_3.h>

#include <emscripten/bind.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace vfc_page {

// What goes between the page and its core: arrays, files, and coordinates.

namespace VFC = CGAL::Volume_filling_curves;

template <typename Number>
emscripten::val array(const std::vector<Number>& numbers)
{
  return emscripten::val(emscripten::typed_memory_view(numbers.size(), numbers.data()))
      .template call<emscripten::val>("slice");
}

inline emscripten::val bytes(const std::string& content)
{
  return array(std::vector<std::uint8_t>(content.begin(), content.end()));
}

// The readers and writers take files, which are in memory here.
inline void write_file(const std::string& name, const std::string& content)
{
  std::ofstream(name, std::ios::binary) << content;
}

inline std::string read_file(const std::string& name)
{
  std::ostringstream text;
  text << std::ifstream(name, std::ios::binary).rdbuf();
  return text.str();
}

inline std::string obj(const VFC::Curve_network_3<>& curve)
{
  const std::string name = "curve.obj";
  if(!CGAL::IO::write_curve_network(name, curve))
    throw std::runtime_error("no memory for the file");
  return read_file(name);
}

// The content of a file that a user saves: "curve.obj", "start.obj" or "curve.cert".
template <typename Live>
emscripten::val saved_file(const Live& live, const std::string& name)
{
  if(name == "curve.obj") return emscripten::val(obj(live.curve()));
  if(name == "start.obj") return emscripten::val(obj(live.start()));
  return bytes(live.certificate());
}

// The units of a box: the origin in its middle and a diagonal of 1, for which single precision
// suffices.
class Page_units
{
  using Point = VFC::Curve_network_3<>::Point_3;

public:
  explicit Page_units(const CGAL::Bbox_3& box)
      : m_origin((box.xmin() + box.xmax()) / 2,
                 (box.ymin() + box.ymax()) / 2,
                 (box.zmin() + box.zmax()) / 2),
        m_size(std::hypot(box.x_span(), box.y_span(), box.z_span()))
  {}

  // one unit of the page, in the input's unit
  double unit() const { return m_size; }

  double length(double input) const { return input / m_size; }

  Point in_input(double x, double y, double z) const
  {
    return Point(m_origin.x() + m_size * x, m_origin.y() + m_size * y, m_origin.z() + m_size * z);
  }

  template <typename Points>
  emscripten::val coordinates(const Points& points) const
  {
    std::vector<float> numbers;
    for(const Point& p : points)
      for(const double x : {p.x() - m_origin.x(), p.y() - m_origin.y(), p.z() - m_origin.z()})
        numbers.push_back(static_cast<float>(length(x)));
    return array(numbers);
  }

private:
  Point m_origin;
  double m_size;
};

} // namespace vfc_page

#endif // VFC_PAGE_VALUES_H
