// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_RUN_WATCH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_RUN_WATCH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <limits>
#include <thread>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Exception that ends loops that cannot return early, see Run_watch::check(). No public function
// throws it.
struct Run_stopped
{};

class Run_watch;

// Scope in which the current thread, and the blocks of loops that it starts, in whatever threads
// they run, have a watch: loops over blocks, and loops that call check_run(), or check() without a
// watch, end with Run_stopped once the run is to stop. A null watch suspends an outer scope.
class Watched_scope
{
public:
  explicit Watched_scope(Run_watch* watch) : m_outer(std::exchange(current(), watch)) {}
  ~Watched_scope() { current() = m_outer; }

  Watched_scope(const Watched_scope&) = delete;
  Watched_scope& operator=(const Watched_scope&) = delete;

  // Calls a function of the user outside of any scope: if it calls the library, that is no part of
  // the run, must not report to it, and must not call the function again.
  template <typename Function>
  static auto outside(const Function& f)
  {
    const Watched_scope scope(nullptr);
    return f();
  }

  static Run_watch*& current()
  {
    thread_local Run_watch* watch = nullptr;
    return watch;
  }

private:
  Run_watch* m_outer;
};

// Clock of a run, its time limit, the function that reports progress and may end the run, and the
// one that saves its state. Every loop that can last longer than some milliseconds calls
// must_stop(), in any thread, which takes some 25 ns to read the clock. A stop is final, except for
// the measures that grant() allows.
class Run_watch
{
public:
  using Progress_function = std::function<bool(const Run_progress&)>;

  // Points of a run at which its state is saved.
  enum class Checkpoint
  {
    STEP,       // before a step
    END,        // the run ends before its goal
    PART,       // before a part without checkpoints, which is resumed at its beginning only
    END_IN_PART // the run ends before its goal within this part
  };

  static constexpr double never = std::numeric_limits<double>::infinity();

  // Grace, in seconds, of a run that completes its current work; limits are kept within 0.3
  // seconds.
  static constexpr double moment = 0.15;

  // Starts the clock; limit and grace are in seconds. The run must stop within the grace after the
  // limit or an interruption. Code that can end earlier tests is_time_over() and is_interrupted().
  explicit Run_watch(double limit = never, Progress_function progress = nullptr, double grace = 0)
      : m_limit(limit), m_grace(grace), m_report(std::move(progress))
  {}

  Run_watch(const Run_watch&) = delete;
  Run_watch& operator=(const Run_watch&) = delete;

  // of the clock
  double seconds() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

  // Returns whether the run is to end, and reports progress if a report is due.
  bool must_stop()
  {
    if(m_is_stopped.load(std::memory_order_relaxed)) return true;
    const double now = seconds();
    if(now >= m_stop)
      m_is_stopped = true;
    else if(m_report && is_own_thread() && now >= m_next_report)
      report();
    return m_is_stopped;
  }

  // The same, with the completed fraction of the stage.
  bool must_stop(double fraction)
  {
    note_fraction(fraction);
    return must_stop();
  }

  // Throws Run_stopped if the run is to end.
  void check()
  {
    if(must_stop()) throw Run_stopped();
  }

  // The same, but only every 256th call, for callers whose steps take nanoseconds.
  void check_sometimes(unsigned& counter)
  {
    constexpr unsigned calls = 256;
    if(++counter % calls == 0) check();
  }

  bool is_time_over() const { return !leaves(0); }
  bool is_interrupted() const { return m_is_interrupted; }

  // Returns whether work that takes these seconds ends in time.
  bool leaves(double seconds) const { return this->seconds() + seconds < m_limit; }

  // Grants these seconds to work after a stop. After an interruption, progress is not reported
  // again.
  void grant(double seconds)
  {
    const double end = this->seconds() + seconds;
    m_limit = m_is_interrupted ? end : (std::max)(m_limit, end);
    m_stop = m_limit;
    m_is_stopped = false;
  }

  // The following functions are for the thread that constructed the watch. In others, begin(),
  // note_fraction() and note() have no effect.

  void begin(Run_stage stage)
  {
    if(!is_own_thread()) return;
    m_progress.stage = stage;
    m_progress.fraction = 0;
    report();
  }

  void note_fraction(double fraction)
  {
    if(!is_own_thread()) return;
    m_progress.fraction = (std::max)(m_progress.fraction, (std::min)(fraction, 1.));
  }

  // Records the current state of a flow, and reports it.
  template <typename Flow>
  void note(const Flow& flow)
  {
    if(!is_own_thread()) return;
    m_progress.iterations = flow.statistics().iterations;
    m_progress.nodes = flow.curve().number_of_nodes();
    m_progress.length = flow.length();
    m_progress.gradient_norm = flow.gradient_norm();
    report();
  }

  // A function to be called at checkpoints; none if no states are saved.
  void set_checkpoint(std::function<void(Checkpoint)> save) { m_save = std::move(save); }

  bool is_saving() const { return m_save != nullptr; }

  void checkpoint(Checkpoint kind) const
  {
    if(m_save) m_save(kind);
  }

  // to be changed before the next report
  Run_progress& progress() { return m_progress; }

  // Reports at once.
  void report()
  {
    if(!m_report || m_is_interrupted) return;
    m_progress.seconds = seconds();
    m_next_report = never; // meanwhile
    if(!Watched_scope::outside([this] { return m_report(m_progress); })) interrupt();
    m_next_report = seconds() + seconds_between_reports;
  }

private:
  using Clock = std::chrono::steady_clock;

  static constexpr double seconds_between_reports = 0.005;

  void interrupt()
  {
    m_is_interrupted = true;
    m_stop = (std::min)(m_stop.load(), seconds() + m_grace);
    m_is_stopped = m_grace == 0;
  }

  bool is_own_thread() const { return std::this_thread::get_id() == m_thread; }

  const Clock::time_point m_start = Clock::now();
  const std::thread::id m_thread = std::this_thread::get_id();
  double m_limit;
  const double m_grace;
  std::atomic<double> m_stop{m_limit + m_grace}; // when it must stop, in the seconds of the clock
  const Progress_function m_report;              // none if nobody wants to know
  std::atomic<bool> m_is_stopped{false}, m_is_interrupted{false};
  std::function<void(Checkpoint)> m_save;
  double m_next_report = 0; // in the seconds of the clock; of the own thread
  Run_progress m_progress;  // likewise
};

// Calls a function in the scope of a watch, and returns whether it came to its end.
template <typename Function>
bool does_in_time(Run_watch& watch, const Function& f)
{
  const Watched_scope scope(&watch);
  try {
    f();
  } catch(const Run_stopped&) {
    return false;
  }
  return true;
}

// Without a watch, that of the thread counts, if it has one.
inline void check(Run_watch* watch)
{
  if(watch == nullptr) watch = Watched_scope::current();
  if(watch != nullptr) watch->check();
}

// Throws Run_stopped if the thread is in a run that is to stop.
inline void check_run()
{
  check(nullptr);
}

inline void check_sometimes(Run_watch* watch, unsigned& counter)
{
  if(watch == nullptr) watch = Watched_scope::current();
  if(watch != nullptr) watch->check_sometimes(counter);
}

inline void check_run_sometimes(unsigned& counter)
{
  check_sometimes(nullptr, counter);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_RUN_WATCH_H
