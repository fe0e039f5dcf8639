// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_SESSION_H
#define VFC_SESSION_H

#include "files/Output_files.h"
#include "reports/Report.h"
#include "session/Console.h"
#include "session/Thread_limit.h"

#include <chrono>
#include <cstddef>
#include <string>

namespace vfc {

// The options that all commands have.
struct Common_options
{
  std::string report;      // a file, "-" for standard output, or empty
  std::size_t threads = 0; // 0 for all
  bool is_quiet = false;
  bool is_verbose = false;
  bool may_overwrite = false;
};

// Session of a command: its messages, results and files.
class Session
{
public:
  Session(const std::string& command, const Common_options& options);

  const Console& console() const { return m_console; }
  Report& report() { return m_report; }
  Output_files& outputs() { return m_outputs; }

  // Checks whether the report can be written, and promises it. \throws Usage_error
  void start_report();

  // Promises a report to a caller that stores it.
  void promise_report() { m_has_report = true; }

  bool has_report() const { return m_has_report; }

  // Refuses to work for nothing, when all outputs are known. \throws Usage_error if the user wants
  // neither a file nor a report
  void require_output() const;

  // Adds an input file, and the option that may replace it, if any; a report never does. \throws
  // Usage_error
  void add_input(const std::string& file, const std::string& replaced_by = "");

  // Prints the findings of the command, unless the report replaces them.
  void print_result(const std::string& text) const;

  // Prints a summary of the command, unless the report replaces it or the user requested quiet.
  void print_summary(const std::string& text) const;

  // Reports the time since the end of the stage before, and returns it. Stages of the same name add
  // up.
  double end_stage(const std::string& stage);

  double seconds() const;

  // Completes the report, and writes it if a file was promised. \throws Usage_error if that is
  // impossible
  void write_report(int exit_status);

private:
  // Makes a signal that ends the program at once write a report.
  void prepare_interruption() const;

  using Clock = std::chrono::steady_clock;

  Common_options m_options;
  Console m_console;
  Report m_report;
  Output_files m_outputs;
  Thread_limit m_threads;
  Clock::time_point m_start = Clock::now(), m_stage_start = m_start;
  double m_start_cpu_seconds;
  bool m_has_report = false;
};

} // namespace vfc

#endif // VFC_SESSION_H
