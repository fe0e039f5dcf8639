// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "batch/Crash_record.h"

#ifndef _WIN32

#include <array>
#include <csignal>
#include <cstddef>
#include <unistd.h>

namespace vfc {
namespace {

constexpr std::array signals_of_crashes = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

// Data that a signal handler may read.
std::string line_of_crash;
volatile std::sig_atomic_t descriptor = -1;

// Stack of the handler: the usual one may have overflowed.
std::array<char, 1 << 16> stack;

} // namespace

extern "C" {
static void record_crash(int signal)
{
  const char* text = line_of_crash.data();
  const char* const end = text + line_of_crash.size();
  while(descriptor >= 0 && text < end) {
    const auto written = ::write(descriptor, text, static_cast<std::size_t>(end - text));
    if(written <= 0) break;
    text += written;
  }
  ::raise(signal); // ends the process: SA_RESETHAND has restored the system's action
}
}

Crash_record::Crash_record(std::FILE* file, const std::string& line)
{
  line_of_crash = line;
  descriptor = ::fileno(file);
  stack_t other = {};
  other.ss_sp = stack.data();
  other.ss_size = stack.size();
  ::sigaltstack(&other, nullptr);
  struct sigaction action = {};
  action.sa_handler = record_crash;
  action.sa_flags = static_cast<int>(SA_ONSTACK | SA_NODEFER | SA_RESETHAND);
  for(const int signal : signals_of_crashes) ::sigaction(signal, &action, nullptr);
}

Crash_record::~Crash_record()
{
  for(const int signal : signals_of_crashes) std::signal(signal, SIG_DFL);
  descriptor = -1;
}

} // namespace vfc

#else

namespace vfc {

Crash_record::Crash_record(std::FILE*, const std::string&) {}
Crash_record::~Crash_record() {}

} // namespace vfc

#endif
