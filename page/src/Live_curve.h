// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_LIVE_CURVE_H
#define VFC_LIVE_CURVE_H

#include "Hand.h"

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>
#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/internal/knots/Unknot_proofs.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace vfc_page {

namespace VFC = CGAL::Volume_filling_curves;

using Curve = VFC::Curve_network_3<>;
using Guard = VFC::Isotopy_guard_3<>;
using Flow = VFC::Curve_flow_3<>;
using Point = Curve::Point_3;

class Live_search;

// A knot or link in the hands of a user, which flows, is searched, and is pulled at its nodes, in
// any order. One guard makes all changes, so that one certificate records the way from the curve as
// it was loaded to the present one. Undo returns to an earlier curve on this way.
class Live_curve
{
public:
  // \throws std::invalid_argument unless the curves are closed and embedded
  explicit Live_curve(const Curve& curve);
  ~Live_curve();

  const Curve& start() const { return m_start; }
  const Curve& curve() const { return m_curve; }
  const Flow& flow() const { return *m_flow; }

  // --- The flow

  // Makes a step, and returns whether the curve is not tight yet. A thickness that turns out too
  // small for the curve, as that of a ring between thin strands, is raised.
  bool step();

  void set_thickness(double thickness);

  // the thickness that suits the curve that was loaded or, later, found by a search
  double measured_thickness() const { return m_measured_thickness; }

  // --- The search

  void begin_search(std::size_t seed);
  bool is_searching() const { return m_search != nullptr; }

  // Searches for about this time, and returns whether the search goes on.
  bool search(double seconds);

  // the polygon that the search has found so far, which no guard has certified yet
  Curve searched_curve() const;

  // Ends the search: the curve adopts its result so far by certified moves.
  void end_search();

  // --- The hand

  // Pulls a node, and those nearby a little less, towards a target; by at most half a thickness.
  // Returns the share of this way that the guard let the node go: 1 unless a strand is in the way,
  // which is touched but not met.
  // The curve is remeshed; held_node() follows the node.
  void hold(std::size_t v);
  double pull(const Point& target);
  void release();
  std::size_t held_node() const { return m_hand.node(); } // or Curve::null_node()

  // --- Results

  // whether all components are proved to be unknotted and unlinked
  bool is_proved_trivial() const { return m_proofs.is_proved(); }

  std::string certificate() const { return m_guard->certificate().bytes(); }

  // --- Undo

  // Keeps the present curve as one to which undo() returns.
  void remember();
  bool can_undo() const { return !m_moments.empty(); }
  void undo();

private:
  struct Moment;
  using Targets = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

  void measure_and_begin_flow();
  void begin_flow(double thickness);
  void note_change();
  Targets targets(const Point& target) const;

  const Curve m_start;
  Curve m_curve;
  std::unique_ptr<Guard> m_guard;
  std::unique_ptr<Flow> m_flow;
  double m_measured_thickness = 0;
  std::unique_ptr<Live_search> m_search;
  VFC::internal::Unknot_proofs m_proofs;
  Hand m_hand;
  std::vector<Moment> m_moments;
};

} // namespace vfc_page

#endif // VFC_LIVE_CURVE_H
