// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_RESULTS_H
#define VFC_RESULTS_H

#include "batch/Crash_record.h"
#include "reports/Report.h"

#include <cstdio>
#include <memory>
#include <string>
#include <unordered_map>

namespace vfc {

// Results of a batch so far: the reports of all runs, one per line of a file. Processes with other
// shards may append concurrently, and each may be killed at any moment: complete lines are never
// lost, and the next process that reads or writes drops an incomplete line. On a file system
// without locks, a process may take a line that another is writing for incomplete. Errors are
// thrown as Usage_error.
class Results
{
public:
  // Outcome of an input.
  struct Outcome
  {
    int exit_status;
    std::string status; // of the report
  };

  // Creates the file if there is none, and refuses a file with other contents.
  Results(const std::string& path, const std::string& command);

  // Writes the current report if the process crashes while the record exists.
  Crash_record record_crash(const Report& report) const
  {
    return {m_file.get(), report.to_line() + '\n'};
  }

  // Appends the report of a run, and flushes it to the disk.
  void add(const Report& report);

  // Returns null if no run for this input has ended.
  const Outcome* find(const std::string& input) const;

private:
  std::string whole_lines();
  void append(const std::string& text);
  bool read_line(const std::string& line);
  [[noreturn]] void fail(const std::string& what) const;

  std::string m_path, m_command;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> m_file;
  std::unordered_map<std::string, Outcome> m_outcomes;
};

} // namespace vfc

#endif // VFC_RESULTS_H
