// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Live_curve.h"

#include "Live_search.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace vfc_page {

namespace {

// Lengths in units of the thickness. A pull takes a stretch of the curve along as it is, which
// keeps its bend; beyond, the nodes follow less and less, and are smoothed.
constexpr double max_pull = 0.5;
constexpr double stiff_length = 1; // to each side of the held node
constexpr double reach_of_pull = 4;
constexpr double smoothing = 0.5;       // share of the way to the middle of the neighbors
constexpr double strand_distance = 1.2; // strands in contact end a pull, before the guard's halving

constexpr std::size_t max_moments = 50; // to return to

// as untangle() decides
constexpr double tolerance = 7e-3;
constexpr double loose = 0.05;
constexpr double gradient_of_fitting_thickness = 0.05;

// The certificate is one stretch of bytes, of which an earlier one is the beginning.
using Record = std::
    tuple<std::string, std::uint64_t, std::uint64_t, std::vector<std::uint64_t>, std::uint64_t>;

double share_of_pull(double distance)
{
  if(distance <= stiff_length) return 1;
  return (1 + std::cos(CGAL_PI * (distance - stiff_length) / (reach_of_pull - stiff_length))) / 2;
}

void check_closed(const Curve& curve)
{
  for(std::size_t c = 0; c < curve.number_of_components(); ++c)
    if(!curve.is_closed(c))
      throw std::invalid_argument("component " + std::to_string(c + 1) +
                                  " is not closed: this page takes knots and links");
}

} // namespace

// A curve on the way, and the record up to there, whose bytes are the first ones of any later
// record.
struct Live_curve::Moment
{
  Curve curve;
  double thickness, measured_thickness;
  std::size_t number_of_bytes;
  Record record; // without its bytes
};

Live_curve::Live_curve(const Curve& curve) : m_start(curve), m_curve(curve)
{
  if(m_curve.number_of_nodes() == 0) throw std::invalid_argument("there is no curve");
  check_closed(m_curve);
  if(!VFC::is_embedded(m_curve)) throw std::invalid_argument("two edges of the curve meet");
  m_guard = std::make_unique<Guard>(m_curve);
  m_guard->start_recording();
  measure_and_begin_flow();
}

Live_curve::~Live_curve()
{
  release();
}

// --- The flow

void Live_curve::measure_and_begin_flow()
{
  constexpr double measured = 0; // as thickness
  begin_flow(measured);
  m_measured_thickness = m_flow->thickness();
}

void Live_curve::begin_flow(double thickness)
{
  VFC::Curve_flow_parameters parameters;
  parameters.thickness = thickness;
  parameters.preconditioner = VFC::Preconditioner::CONTACT; // as untangle() has
  m_flow = std::make_unique<Flow>(*m_guard, parameters);
  note_change();
}

void Live_curve::note_change()
{
  m_proofs.update(m_curve);
}

bool Live_curve::step()
{
  const bool has_moved = m_flow->step();
  note_change();
  if(m_flow->gradient_norm() >= tolerance) return has_moved;
  if(m_flow->loose_share() < loose) return false;
  const double factor = gradient_of_fitting_thickness / m_flow->gradient_norm();
  if(factor >= 2) set_thickness(factor * m_flow->thickness());
  return has_moved;
}

void Live_curve::set_thickness(double thickness)
{
  VFC::Curve_flow_parameters parameters = m_flow->parameters();
  parameters.thickness = thickness;
  m_flow->set_parameters(parameters);
  note_change();
}

// --- The search

void Live_curve::begin_search(std::size_t seed)
{
  m_search = std::make_unique<Live_search>(m_curve, seed);
}

bool Live_curve::search(double seconds)
{
  if(m_search->run(seconds)) return true;
  end_search();
  return false;
}

Curve Live_curve::searched_curve() const
{
  return m_search->result();
}

void Live_curve::end_search()
{
  m_flow.reset(); // which would follow each change
  m_search->apply(*m_guard);
  m_search.reset();
  measure_and_begin_flow();
}

// --- The hand

void Live_curve::hold(std::size_t v)
{
  if(v >= m_curve.number_of_nodes()) throw std::invalid_argument("there is no such node");
  m_hand.hold(*m_guard, v);
}

double Live_curve::pull(const Point& target)
{
  VFC::Bend_limits<Point> limits;
  limits.strand_distance = strand_distance * m_flow->thickness();
  m_guard->set_bend_limits(limits);
  const double share = m_guard->advance_nodes(targets(target))[m_hand.node()];
  m_guard->set_bend_limits({});
  m_flow->set_spacing(m_flow->parameters().spacing);
  note_change();
  return share;
}

void Live_curve::release()
{
  m_hand.release(*m_guard);
}

Live_curve::Targets Live_curve::targets(const Point& target) const
{
  using VFC::internal::to_vector;
  using VFC::internal::Vector;
  Targets targets = VFC::point_matrix(m_curve);
  const double r = m_flow->thickness();
  const std::size_t held = m_hand.node();
  const auto position = [&](std::size_t v) { return to_vector(m_curve.point(v)); };
  const Vector whole = to_vector(target) - position(held);
  const Vector way = (std::min)(1., max_pull * r / whole.norm()) * whole;
  const auto move = [&](std::size_t v, double share) {
    const Vector middle = (position(m_curve.neighbor(v, 0)) + position(m_curve.neighbor(v, 1))) / 2;
    const Vector x = position(v) + share * way + smoothing * (1 - share) * (middle - position(v));
    for(int k = 0; k < 3; ++k) targets(static_cast<Eigen::Index>(v), k) = x[k];
  };
  move(held, 1);
  for(std::size_t side = 0; side < 2; ++side) {
    double distance = 0; // along the curve, in units of the thickness
    std::size_t last = held, v = m_curve.neighbor(held, side);
    while(v != held) {
      distance += (position(v) - position(last)).norm() / r;
      if(distance >= reach_of_pull) break;
      move(v, share_of_pull(distance));
      last = std::exchange(v, m_curve.neighbor(v, m_curve.neighbor(v, 0) == last ? 1 : 0));
    }
  }
  return targets;
}

// --- Undo

void Live_curve::remember()
{
  if(m_moments.size() == max_moments) m_moments.erase(m_moments.begin());
  const auto& [bytes, operations, last_node, numbers, next] = m_guard->record()->contents();
  m_moments.push_back({m_hand.released(m_curve), m_flow->thickness(), m_measured_thickness,
                       bytes.size(), Record("", operations, last_node, numbers, next)});
}

void Live_curve::undo()
{
  if(m_moments.empty()) return;
  m_search.reset();
  release();
  Moment moment = std::move(m_moments.back());
  m_moments.pop_back();
  std::get<std::string>(moment.record) =
      std::get<0>(m_guard->record()->contents()).substr(0, moment.number_of_bytes);
  m_flow.reset();
  m_guard.reset();
  m_curve = std::move(moment.curve);
  m_guard = std::make_unique<Guard>(m_curve);
  m_guard->start_recording();
  m_guard->record()->contents() = moment.record;
  begin_flow(moment.thickness);
  m_measured_thickness = moment.measured_thickness;
}

} // namespace vfc_page
