// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_WORK_WATCH_H
#define VFC_WORK_WATCH_H

#include <chrono>
#include <functional>
#include <limits>
#include <string>
#include <utility>

namespace vfc {

// Exception that ends work; not a std::exception, since code that tries alternatives must not take
// it for a failed attempt.
struct Work_stopped
{};

// Time limit of work, and its progress function.
class Work_watch
{
public:
  static constexpr double never = std::numeric_limits<double>::infinity();

  // receives the step, such as "closing holes", and the seconds so far; returns whether to continue
  using Progress_function = std::function<bool(const std::string& step, double seconds)>;

  // Starts the clock; the limit is in seconds.
  explicit Work_watch(double limit = never, Progress_function progress = nullptr)
      : m_limit(limit), m_progress(std::move(progress))
  {}

  // Takes note of the step that begins. \throws Work_stopped
  void begin(const std::string& step)
  {
    m_step = step;
    m_next_progress = 0;
    check();
  }

  // Throws Work_stopped if the time is over or the progress function ends the work; takes 50 ns.
  void check()
  {
    const double now = seconds();
    if(now >= m_limit) throw Work_stopped();
    if(!m_progress || now < m_next_progress) return;
    m_next_progress = now + seconds_between_progress;
    m_is_interrupted = !m_progress(m_step, now);
    if(m_is_interrupted) throw Work_stopped();
  }

  const std::string& step() const { return m_step; }

  bool is_interrupted() const { return m_is_interrupted; }

private:
  using Clock = std::chrono::steady_clock;

  static constexpr double seconds_between_progress = 0.005;

  double seconds() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

  Clock::time_point m_start = Clock::now();
  double m_limit, m_next_progress = 0;
  Progress_function m_progress;
  std::string m_step;
  bool m_is_interrupted = false;
};

} // namespace vfc

#endif // VFC_WORK_WATCH_H
