// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_BENCHMARK_STAGE_PROFILE_H
#define VFC_BENCHMARK_STAGE_PROFILE_H

#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Default_curve_flow_visitor.h>

#include <CGAL/Real_timer.h>

#include <cstddef>

#include "Json_line.h"

namespace vfc_benchmark {

// A visitor that counts the nodes of all iterations, to report the time of each stage in
// microseconds per node and iteration. What happens before the first step (thickness, first
// remeshing) is the setup and does not count.
class Stage_profile : public CGAL::Volume_filling_curves::Default_curve_flow_visitor
{
  using Statistics = CGAL::Volume_filling_curves::Curve_flow_statistics;

public:
  Stage_profile() { m_timer.start(); }

  template <typename Flow>
  void on_start(const Flow& flow)
  {
    m_setup_seconds = m_timer.time();
    m_start = m_end = flow.statistics();
    m_nodes = flow.curve().number_of_nodes();
  }

  template <typename Flow>
  void on_iteration(const Flow& flow)
  {
    m_node_iterations += m_nodes;
    m_nodes = flow.curve().number_of_nodes();
    m_end = flow.statistics();
  }

  double setup_seconds() const { return m_setup_seconds; }

  double mean_number_of_nodes() const
  {
    return static_cast<double>(m_node_iterations) / static_cast<double>(iterations());
  }

  Json_line microseconds_per_node() const
  {
    Json_line line;
    line.add("medial_spheres", per_node(&Statistics::seconds_medial_spheres))
        .add("direction", per_node(&Statistics::seconds_direction))
        .add("motion", per_node(&Statistics::seconds_motion))
        .add("remeshing", per_node(&Statistics::seconds_remeshing));
    return line;
  }

private:
  std::size_t iterations() const { return m_end.iterations - m_start.iterations; }

  double per_node(double Statistics::*seconds) const
  {
    return 1e6 * (m_end.*seconds - m_start.*seconds) / static_cast<double>(m_node_iterations);
  }

  CGAL::Real_timer m_timer;
  double m_setup_seconds = 0;
  Statistics m_start, m_end;
  std::size_t m_nodes = 0, m_node_iterations = 0;
};

} // namespace vfc_benchmark

#endif // VFC_BENCHMARK_STAGE_PROFILE_H
