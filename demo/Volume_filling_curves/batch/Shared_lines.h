// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_SHARED_LINES_H
#define VFC_SHARED_LINES_H

#include "batch/Crash_record.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace vfc {

// A file that several processes append lines to, each of which may be killed at any moment. Whole
// lines are never lost; the part of a line that somebody could not complete is dropped by the next
// one who looks. A process locks bytes of the file, which need not exist; the system lifts these
// locks when the process ends, however it does. Where a file system has none, two processes may
// reserve the same number, and one may take a line that another is writing for unfinished.
//
// A process must not open the file a second time, since its locks end when it closes any of them.
// Errors are thrown as Usage_error.
class Shared_lines
{
public:
  // Creates the file if there is none.
  explicit Shared_lines(const std::string& path);
  Shared_lines(const Shared_lines&) = delete;
  Shared_lines& operator=(const Shared_lines&) = delete;
  ~Shared_lines();

  const std::string& path() const { return m_path; }

  // returns the lines that were appended since the last call, by whomever, without their ends
  std::vector<std::string> read();

  // Appends a line, which is on the disk then.
  void append(const std::string& line);

  // Writes a line, without its end, if the process crashes as long as the record exists.
  Crash_record record_crash(const std::string& line) const { return {m_file, line + '\n'}; }

  // Reserves a number for this process. Returns whether no other process has it.
  bool reserve(std::size_t number);
  void release(std::size_t number);

private:
  std::string unread_lines();
  [[noreturn]] void fail(const std::string& what) const;

  std::string m_path;
  std::FILE* m_file;
  std::uintmax_t m_read = 0; // bytes
};

} // namespace vfc

#endif // VFC_SHARED_LINES_H
