// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_REPLAY_LOG_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_REPLAY_LOG_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/state/State_reader.h>
#include <CGAL/Volume_filling_curves/internal/state/State_writer.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The decisions of a run between its stages. A run that resumes takes the same path through the
// program, with the same decisions, and leaves out all stages before the one that it was in; so the
// program does not need to be written as an automaton.
class Replay_log
{
public:
  // Returns what was decided here by the run that this one goes on with, and otherwise decide().
  template <typename Decide>
  auto operator()(const Decide& decide)
  {
    using Decision = decltype(decide());
    if(m_next < m_decisions.size()) {
      Decision decision{};
      State_reader reader(m_decisions[m_next++]);
      reader(decision);
      return decision;
    }
    const Decision decision = decide();
    State_writer writer;
    writer(decision);
    m_decisions.push_back(writer.bytes());
    ++m_next;
    return decision;
  }

  // Writes or reads everything, see State_writer.
  template <typename Archive>
  void serialize(Archive& archive)
  {
    archive(m_decisions);
  }

private:
  std::vector<std::string> m_decisions;
  std::size_t m_next = 0;
};

} // namespace internal

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_REPLAY_LOG_H
