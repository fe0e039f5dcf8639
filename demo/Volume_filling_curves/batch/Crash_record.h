// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CRASH_RECORD_H
#define VFC_CRASH_RECORD_H

#include <cstdio>
#include <string>

namespace vfc {

// Record of crashes: while it exists, a crash of the process, such as a segmentation fault or an
// overflow of the main thread's stack, appends a line to a file before the process ends. Otherwise
// a batch would start with the same input, and crash, each time. At most one record at a time; has
// no effect on Windows.
class Crash_record
{
public:
  // Takes a file opened for appending, and the line with its end.
  Crash_record(std::FILE* file, const std::string& line);
  Crash_record(const Crash_record&) = delete;
  Crash_record& operator=(const Crash_record&) = delete;
  ~Crash_record();
};

} // namespace vfc

#endif // VFC_CRASH_RECORD_H
