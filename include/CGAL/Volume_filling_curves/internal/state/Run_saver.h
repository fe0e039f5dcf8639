// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_RUN_SAVER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_RUN_SAVER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Run_state.h>
#include <CGAL/Volume_filling_curves/internal/state/State_reader.h>
#include <CGAL/Volume_filling_curves/internal/state/State_writer.h>
#include <CGAL/Volume_filling_curves/internal/state/run_fingerprint.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_run_parameters.h>

#include <functional>
#include <optional>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Between a run and whoever saves its state: offers the state to be taken now and then, and has it
// read where a run resumes. A state is what the run depends on, and then what its parts have
// written, from the outer ones to the inner ones, which is also the order of reading.
class Run_saver
{
public:
  // Takes a function that returns the facts, which can be long to find, and are not always needed.
  // Throws Run_state_error if there is a state to resume from that is of another run.
  template <typename Find_facts>
  Run_saver(const Curve_run_parameters& parameters, const Find_facts& find_facts)
      : m_checkpoint(parameters.checkpoint)
  {
    const bool is_resuming = parameters.resume_from && !parameters.resume_from->is_empty();
    if(is_saving() || is_resuming) m_facts = find_facts();
    if(is_resuming) open(*parameters.resume_from);
  }

  // what there is to be read of the state that the run resumes from; null if that is nothing
  State_reader* reader() { return m_reader && !m_reader->is_at_end() ? &*m_reader : nullptr; }

  bool is_saving() const { return static_cast<bool>(m_checkpoint); }

  // Offers the state that write(State_writer&) writes.
  template <typename Write>
  void offer(bool is_last, const Write& write) const
  {
    if(!is_saving()) return;
    const auto take_state = [&] {
      State_writer writer;
      writer(m_facts);
      write(writer);
      return Run_state::of_body(writer.bytes());
    };
    m_checkpoint(Run_checkpoint(take_state, is_last));
  }

private:
  void open(const Run_state& state)
  {
    m_reader.emplace(state.body());
    Run_facts facts;
    (*m_reader)(facts);
    check_facts(facts, m_facts);
  }

  const std::function<void(const Run_checkpoint&)>& m_checkpoint; // none if nothing is saved
  Run_facts m_facts;
  std::optional<State_reader> m_reader;
};

} // namespace internal

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_RUN_SAVER_H
