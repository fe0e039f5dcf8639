// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_RESULTS_H
#define VFC_RESULTS_H

#include "batch/Shared_lines.h"
#include "reports/Report.h"

#include <string>
#include <unordered_map>

namespace vfc {

// The results of a batch so far: the reports of all runs, one per line of a file, which
// other processes may share.
class Results
{
public:
  // What became of an input.
  struct Outcome
  {
    int exit_status;
    std::string status; // of the report
  };

  // Reads what is there. \throws Usage_error if the file holds something else
  Results(const std::string& path, const std::string& command);

  // Takes an input into this process' hands. Returns whether nobody else has it or is done with it.
  bool reserve(const std::string& input);

  // Writes the report as it is when the process crashes, as long as the record exists.
  Crash_record record_crash(const Report& report) const
  {
    return m_file.record_crash(report.to_line());
  }

  // Writes the report of a run for an input that was reserved.
  void add(const std::string& input, const Report& report);

  // returns null if no run for this input has come to its end
  const Outcome* find(const std::string& input) const;

private:
  void read_lines();
  bool read_line(const std::string& line);

  Shared_lines m_file;
  std::string m_command;
  std::size_t m_number_of_lines = 0;
  std::unordered_map<std::string, Outcome> m_outcomes;
};

} // namespace vfc

#endif // VFC_RESULTS_H
