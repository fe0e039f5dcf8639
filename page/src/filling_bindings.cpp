// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The fillings of the live page, as a worker calls them.

#include "Live_filling.h"
#include "page_values.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>

#include <cstdint>
#include <string>
#include <vector>

namespace vfc_page {

namespace {

using emscripten::val;

class Page_filling
{
public:
  explicit Page_filling(const Live_filling::Mesh& mesh) : m_live(mesh), m_units(m_live.box()) {}

  // Settings are {thickness, bendRadius, ratio}, with lengths in the page's units. Events are
  // functions of the page: show(), report(), and keep(), which takes a state if isStateDue().
  void fill(val settings, val events)
  {
    m_live.fill(in_input(settings),
                {[&] { events.call<void>("show"); },
                 [&](const VFC::Run_progress& progress) {
                   events.call<void>("report", std::string(VFC::to_string(progress.stage)),
                                     progress.fraction,
                                     static_cast<unsigned int>(progress.iterations));
                 },
                 [&](const VFC::Run_checkpoint& checkpoint) {
                   if(events.call<bool>("isStateDue"))
                     events.call<void>("keep", bytes(checkpoint.state().bytes()));
                 }});
  }

  void restore(val settings, const std::string& state)
  {
    m_live.restore(in_input(settings), VFC::Run_state(state));
  }

  val domain() const
  {
    std::vector<std::uint32_t> corners;
    for(const auto f : m_live.mesh().faces())
      for(const auto v : vertices_around_face(m_live.mesh().halfedge(f), m_live.mesh()))
        corners.push_back(static_cast<std::uint32_t>(v));
    val domain = val::object();
    domain.set("points", m_units.coordinates(m_live.mesh().points()));
    domain.set("triangles", array(corners));
    return domain;
  }

  // The coordinates of all nodes, and the number of nodes of each strand.
  val picture() const
  {
    std::vector<Live_filling::Point> points;
    val lengths = val::array();
    for(const auto& strand : m_live.strands()) {
      points.insert(points.end(), strand.begin(), strand.end());
      lengths.call<void>("push", static_cast<unsigned int>(strand.size()));
    }
    val picture = val::object();
    picture.set("coordinates", m_units.coordinates(points));
    picture.set("strands", lengths);
    return picture;
  }

  // Lengths in the input's unit.
  val result() const
  {
    const Live_filling::Result& result = m_live.result();
    val values = val::object();
    values.set("status", std::string(VFC::to_string(result.status)));
    values.set("reason", result.reason);
    values.set("length", VFC::length(m_live.curve()));
    values.set("withinThickness", result.coverage.fraction_within_r);
    values.set("bendRadius", result.min_bend_radius);
    values.set("strandDistance", result.min_strand_distance);
    return values;
  }

  double unit() const { return m_units.unit(); }

  val file(const std::string& name) const { return saved_file(m_live, name); }

private:
  Filling_settings in_input(const val& settings) const
  {
    const auto number = [&](const char* name) { return settings[name].as<double>(); };
    return {unit() * number("thickness"), unit() * number("bendRadius"), number("ratio")};
  }

  Live_filling m_live;
  const Page_units m_units;
};

// The inside of the surface in the content of a file with this name.
Page_filling* domain(const std::string& name, const std::string& content)
{
  write_file(name, content);
  return new Page_filling(read_surface(name));
}

} // namespace

EMSCRIPTEN_BINDINGS(live_filling)
{
  emscripten::function("domain", &domain, emscripten::allow_raw_pointers());
  emscripten::class_<Page_filling>("Filling")
      .function("fill", &Page_filling::fill)
      .function("restore", &Page_filling::restore)
      .function("domain", &Page_filling::domain)
      .function("picture", &Page_filling::picture)
      .function("result", &Page_filling::result)
      .function("unit", &Page_filling::unit)
      .function("file", &Page_filling::file);
}

} // namespace vfc_page
