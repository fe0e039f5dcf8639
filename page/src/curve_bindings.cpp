// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The curves of the live page, as a worker calls them. Coordinates go to and fro in units of the
// box of the curve as it was loaded.

#include "Live_curve.h"
#include "page_values.h"

#include <CGAL/Volume_filling_curves/IO/curve_network.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/identify.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace vfc_page {

using emscripten::val;

// --- Curves in and out

// Reads the content of a file with this name, whose extension is that of its format.
Curve read_curve(const std::string& name, const std::string& content)
{
  write_file(name, content);
  Curve curve;
  std::vector<VFC::Curve_defect> defects;
  if(CGAL::IO::read_embedded_curve_network(name, curve, defects)) return curve;
  for(const VFC::Curve_defect& defect : defects)
    if(VFC::is_error(defect.kind))
      throw std::invalid_argument(
          (defect.line ? "line " + std::to_string(defect.line) + ": " : "") + defect.message);
  throw std::invalid_argument("there is no curve");
}

// --- The curve on the page

class Page_curve
{
public:
  explicit Page_curve(const Curve& curve) : m_live(curve), m_units(curve.bbox()) {}

  bool step() { return m_live.step(); }

  // The thickness in units of the measured one.
  double thickness_factor() const
  {
    return m_live.flow().thickness() / m_live.measured_thickness();
  }

  void set_thickness_factor(double f) { m_live.set_thickness(f * m_live.measured_thickness()); }

  void begin_search(unsigned int seed) { m_live.begin_search(seed); }
  bool is_searching() const { return m_live.is_searching(); }
  bool search(double seconds) { return m_live.search(seconds); }
  void end_search() { m_live.end_search(); }

  // Holds the node that is nearest to a point.
  void hold(double x, double y, double z)
  {
    const Point p = m_units.in_input(x, y, z);
    std::size_t nearest = 0;
    for(const std::size_t v : m_live.curve().nodes())
      if(CGAL::compare_distance_to_point(p, m_live.curve().point(v),
                                         m_live.curve().point(nearest)) == CGAL::SMALLER)
        nearest = v;
    m_live.hold(nearest);
  }

  void release() { m_live.release(); }

  double pull(double x, double y, double z) { return m_live.pull(m_units.in_input(x, y, z)); }

  // -1 if no node is held
  int held_node() const
  {
    return m_live.held_node() == Curve::null_node() ? -1 : static_cast<int>(m_live.held_node());
  }

  void remember() { m_live.remember(); }
  bool can_undo() const { return m_live.can_undo(); }
  void undo() { m_live.undo(); }

  // What is seen: the curve, or while it is searched the best polygon so far, as the coordinates of
  // all nodes and the number of nodes of each component.
  val picture() const
  {
    const Curve shown = m_live.is_searching() ? m_live.searched_curve() : m_live.curve();
    val strands = val::array();
    for(std::size_t c = 0; c < shown.number_of_components(); ++c)
      strands.call<void>("push", static_cast<unsigned int>(shown.nodes(c).size()));
    val picture = val::object();
    picture.set("coordinates", m_units.coordinates(shown.points()));
    picture.set("strands", strands);
    picture.set("thickness", m_units.length(m_live.flow().thickness()));
    picture.set("thicknessFactor", thickness_factor());
    picture.set("unit", m_units.unit());
    return picture;
  }

  double length() const { return VFC::length(m_live.curve()); }
  double ropelength() const { return VFC::ropelength(m_live.curve()); }
  bool is_proved_trivial() const { return m_live.is_proved_trivial(); }

  // Names the knot, in at most so many seconds.
  val identity(double seconds) const
  {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    val identity = val::object();
    try {
      const VFC::Link_identity found =
          VFC::identify(m_live.curve(), VFC::parameters::progress([end](const VFC::Run_progress&) {
                          return Clock::now() < end;
                        }));
      identity.set("name", found.name);
      identity.set("isProved", found.is_proved);
      identity.set("knottedness", std::string(VFC::to_string(found.knottedness)));
      identity.set("crossings", static_cast<unsigned int>(found.diagram.crossings.size()));
    } catch(const VFC::Run_interrupted&) {
    }
    return identity;
  }

  val file(const std::string& name) const { return saved_file(m_live, name); }

private:
  Live_curve m_live;
  const Page_units m_units;
};

// --- The curves to choose from

Page_curve* file(const std::string& name, const std::string& content)
{
  return new Page_curve(read_curve(name, content));
}

Page_curve* closed_braid(const std::string& word, unsigned int number_of_nodes)
{
  return new Page_curve(VFC::make_closed_braid(VFC::parse_braid_word(word), number_of_nodes));
}

Page_curve* torus_knot(int p, int q, unsigned int number_of_nodes)
{
  return new Page_curve(VFC::make_torus_knot(p, q, number_of_nodes));
}

Page_curve* hard_unknot(unsigned int number_of_nodes, unsigned int moves, unsigned int seed)
{
  return new Page_curve(VFC::make_hard_unknot(number_of_nodes, moves, seed));
}

// The sentence of an exception, which JavaScript catches as a number.
std::string sentence(std::intptr_t exception)
{
  return reinterpret_cast<const std::exception*>(exception)->what();
}

EMSCRIPTEN_BINDINGS(live_page)
{
  emscripten::function("file", &file, emscripten::allow_raw_pointers());
  emscripten::function("closedBraid", &closed_braid, emscripten::allow_raw_pointers());
  emscripten::function("torusKnot", &torus_knot, emscripten::allow_raw_pointers());
  emscripten::function("hardUnknot", &hard_unknot, emscripten::allow_raw_pointers());
  emscripten::function("sentence", &sentence);
  emscripten::class_<Page_curve>("Curve")
      .function("step", &Page_curve::step)
      .function("setThicknessFactor", &Page_curve::set_thickness_factor)
      .function("beginSearch", &Page_curve::begin_search)
      .function("isSearching", &Page_curve::is_searching)
      .function("search", &Page_curve::search)
      .function("endSearch", &Page_curve::end_search)
      .function("hold", &Page_curve::hold)
      .function("pull", &Page_curve::pull)
      .function("release", &Page_curve::release)
      .function("heldNode", &Page_curve::held_node)
      .function("remember", &Page_curve::remember)
      .function("canUndo", &Page_curve::can_undo)
      .function("undo", &Page_curve::undo)
      .function("picture", &Page_curve::picture)
      .function("length", &Page_curve::length)
      .function("ropelength", &Page_curve::ropelength)
      .function("isProvedTrivial", &Page_curve::is_proved_trivial)
      .function("identity", &Page_curve::identity)
      .function("file", &Page_curve::file);
}

} // namespace vfc_page
