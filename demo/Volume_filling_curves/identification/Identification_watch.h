// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_IDENTIFICATION_WATCH_H
#define VFC_IDENTIFICATION_WATCH_H

#include "options/numbers.h"
#include "session/No_result.h"
#include "session/Patience.h"
#include "session/Progress.h"
#include "session/Session.h"
#include "session/interruption.h"

#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>

#include <cmath>
#include <string>

namespace vfc {

// Shows the progress with a file, and ends it by a signal or the time limit.
class Identification_watch
{
public:
  Identification_watch(const Session& session, const std::string& file, double time_limit)
      : m_file(file), m_progress(session.console()), m_patience(time_limit)
  {}

  // Calls f with a function for the parameter `progress`. \throws No_result
  template <typename Function>
  auto operator()(const Function& f)
  {
    poll_interruptions();
    try {
      return f([this](const CGAL::Volume_filling_curves::Run_progress& progress) {
        if(m_progress.is_due())
          m_progress.show(progress.fraction,
                          m_file + ", " + to_text(std::round(progress.seconds)) + " s");
        return m_patience(progress);
      });
    } catch(const CGAL::Volume_filling_curves::Run_interrupted&) {
      if(is_interruption_requested())
        throw No_result(INTERRUPTED, m_file + ": interrupted, while it was identified");
      throw No_result(LIMIT_REACHED, m_file + ": not identified within the time limit");
    }
  }

private:
  const std::string m_file;
  Progress m_progress;
  const Patience m_patience;
};

} // namespace vfc

#endif // VFC_IDENTIFICATION_WATCH_H
