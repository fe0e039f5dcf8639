// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_RUN_SAVER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_RUN_SAVER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Network_editor.h>
#include <CGAL/Volume_filling_curves/internal/curve/Self_contacts.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/state/Byte_archive.h>
#include <CGAL/Volume_filling_curves/internal/state/Run_state.h>
#include <CGAL/Volume_filling_curves/internal/state/run_fingerprint.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_run_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Node_constraint.h>

#include <array>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Copies a curve without garbage. Reading replaces a curve with the same input.
template <typename Network>
void copy_curve(Byte_archive& archive, Network& curve)
{
  using Editor = Network_editor<Network>;
  std::vector<Vector> points;
  std::vector<std::array<std::size_t, 2>> edges;
  std::vector<std::size_t> origins, constrained;
  std::vector<Node_constraint> constraints;
  auto labels = Editor::labels(curve);
  for(const std::size_t v : curve.nodes()) {
    points.push_back(to_vector(curve.point(v)));
    origins.push_back(curve.origin(v));
    if(curve.is_free(v)) continue;
    constrained.push_back(v);
    constraints.push_back(curve.constraint(v));
  }
  for(const std::size_t e : curve.edges()) edges.push_back({curve.source(e), curve.target(e)});
  archive(points, edges, origins, constrained, constraints, labels);
  if(!archive.is_reading()) return;
  archive.require(points.size() == origins.size());
  for(const Vector& p : points) archive.require(is_in_range(p));
  Editor(curve).replace(to_points(points, curve.traits()), edges, origins, labels);
  archive.require(constrained.size() == constraints.size());
  for(std::size_t k = 0; k < constrained.size(); ++k) {
    archive.require(constrained[k] < points.size());
    curve.set_constraint(constrained[k], constraints[k]);
  }
}

// Copies everything of a guard but its curve. \pre it records if the guard that was written did
template <typename Guard>
void copy_guard(Byte_archive& archive, Guard& guard)
{
  double clearance = guard.clearance();
  archive(clearance);
  std::apply(archive, guard.counts());
  archive.require(clearance >= 0);
  guard.set_clearance(clearance);
  auto* const record = guard.record();
  if(!record) return;
  std::apply(archive, record->contents());
  archive.require(record->numbers().size() == guard.curve().number_of_nodes());
}

// The time of a resumed run counts from its start, as its limit does.
template <typename Part>
void restart_clocks([[maybe_unused]] Part& part)
{
  if constexpr(std::is_same_v<Part, Curve_flow_statistics>)
    part.seconds_medial_spheres = part.seconds_direction = part.seconds_motion =
        part.seconds_remeshing = 0;
}

// Saves the state of a run at the checkpoints of its watch, and resumes a run from such a state:
// the fingerprint, the curve, its guard, and what else the run depends on, a struct with
// `members()`, a tuple of references, and `is_valid()`.
class Run_saver
{
public:
  // Takes the input curve, and a function that returns the rest of the fingerprint, which can take
  // long and is not always needed. Throws Run_state_error if there is a state to resume from that
  // is of another run.
  template <typename Network, typename Fingerprint>
  Run_saver(const Curve_run_parameters& parameters,
            Network& curve,
            Run_watch& watch,
            const Fingerprint& fingerprint)
      : m_checkpoint(parameters.checkpoint), m_watch(watch)
  {
    const Run_state* const former = parameters.resume_from;
    m_is_resuming = former && !former->is_empty();
    if(!m_is_resuming && !m_checkpoint) return;
    Byte_archive input;
    copy_curve(input, curve);
    m_fingerprint = fingerprint() + hash_line("curve", input);
    if(!m_is_resuming) return;
    m_former = Byte_archive(former->body());
    std::string of_former;
    read([&] { m_former(of_former); });
    if(of_former != m_fingerprint)
      throw Run_state_error(first_difference(of_former, m_fingerprint));
  }

  Run_saver(const Run_saver&) = delete;
  Run_saver& operator=(const Run_saver&) = delete;
  ~Run_saver() { m_watch.set_checkpoint(nullptr); }

  bool is_resuming() const { return m_is_resuming; }

  // Replaces the curve by that of the state to resume from, if there is any. Another function,
  // which throws std::invalid_argument, checks it: certificates require an embedded curve.
  template <typename Network, typename Check>
  void resume_curve(Network& curve, const Check& check)
  {
    if(!m_is_resuming) return;
    Network former = curve;
    read([&] {
      copy_curve(m_former, former);
      check_embedded(former);
      check(former);
    });
    curve = std::move(former);
  }

  // Resumes the guard of the curve, and the rest of the state. They must outlive the last
  // checkpoint.
  template <typename Network, typename Guard, typename State>
  void resume(Network& curve, Guard& guard, State& rest)
  {
    if(m_is_resuming)
      read([&] {
        copy_guard(m_former, guard);
        std::apply(m_former, rest.members());
        std::apply([](auto&... parts) { (restart_clocks(parts), ...); }, rest.members());
        m_former.require(m_former.is_at_end() && rest.is_valid());
      });
    if(!m_checkpoint) return;
    m_state = [&] {
      Byte_archive archive;
      archive(m_fingerprint);
      copy_curve(archive, curve);
      copy_guard(archive, guard);
      std::apply(archive, rest.members());
      return Run_state::sealed(archive.bytes());
    };
    m_watch.set_checkpoint([this](Run_watch::Checkpoint moment) { save(moment); });
  }

private:
  template <typename Read>
  static void read(const Read& read_part)
  {
    try {
      read_part();
    } catch(const std::invalid_argument& error) {
      throw Run_state_error(std::string("the state contradicts itself: ") + error.what());
    }
  }

  void save(Run_watch::Checkpoint moment)
  {
    using Checkpoint = Run_watch::Checkpoint;
    if(moment == Checkpoint::PART)
      m_start_of_part = m_state();
    else if(moment == Checkpoint::END_IN_PART)
      m_checkpoint({[this] { return m_start_of_part; }, true});
    else {
      m_start_of_part = Run_state();
      m_checkpoint({m_state, moment == Checkpoint::END});
    }
  }

  const std::function<void(const Run_checkpoint&)>& m_checkpoint; // none if nothing is saved
  Run_watch& m_watch;
  bool m_is_resuming;
  std::string m_fingerprint;
  Byte_archive m_former{std::string_view()}; // to resume from
  std::function<Run_state()> m_state;        // the current one
  Run_state m_start_of_part;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_RUN_SAVER_H
