// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "session/interruption.h"

#include "session/Exit_status.h"

#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <initializer_list>

#ifndef _WIN32
#include <fcntl.h>
#include <unistd.h>
#endif

namespace vfc {
namespace {

volatile std::sig_atomic_t is_polled = 0;
volatile std::sig_atomic_t is_writing = 0;
bool are_polls_ignored = false;
volatile std::sig_atomic_t is_requested = 0;

// read by the handler if they are complete
volatile std::sig_atomic_t has_last_words = 0;
std::string last_words, file_of_report, report_text;
bool is_report_new = false;

#ifndef _WIN32

// Handlers may only call async-signal-safe functions (POSIX).
void write_all(int file, const std::string& text)
{
  for(std::size_t done = 0; done < text.size();) {
    const ssize_t written = ::write(file, text.data() + done, text.size() - done);
    if(written <= 0) return;
    done += static_cast<std::size_t>(written);
  }
}

void say_last_words()
{
  write_all(STDERR_FILENO, last_words);
  if(file_of_report.empty()) return;
  if(file_of_report == "-") return write_all(STDOUT_FILENO, report_text);
  constexpr mode_t mode = 0666; // less the mask
  const int file =
      ::open(file_of_report.c_str(), O_WRONLY | O_CREAT | (is_report_new ? O_EXCL : O_TRUNC), mode);
  if(file < 0) return;
  write_all(file, report_text);
  ::close(file);
}

#else

void say_last_words() {}

#endif

[[noreturn]] void end_at_once()
{
  if(has_last_words != 0) say_last_words();
  std::_Exit(INTERRUPTED);
}

} // namespace

extern "C" {
static void on_interruption(int signal)
{
  if((is_polled == 0 && is_writing == 0) || is_requested != 0) end_at_once();
  is_requested = 1;
  std::signal(signal, on_interruption); // System V resets it
}
}

void handle_signals()
{
#ifdef SIGXFSZ
  std::signal(SIGXFSZ, SIG_IGN);
#endif
  for(const int signal : {SIGINT, SIGTERM}) std::signal(signal, on_interruption);
}

void poll_interruptions()
{
  if(!are_polls_ignored) is_polled = 1;
}

void ignore_polls()
{
  are_polls_ignored = true;
}

Complete_file::Complete_file()
{
  is_writing = 1;
}

Complete_file::~Complete_file()
{
  is_writing = 0;
  const bool has_failed = std::uncaught_exceptions() > 0; // an error names what is lost
  if(is_requested != 0 && is_polled == 0 && !has_failed) end_at_once();
}

bool is_interruption_requested()
{
  return is_requested != 0;
}

bool is_to_go_on(const CGAL::Volume_filling_curves::Run_progress&)
{
  return !is_interruption_requested();
}

void prepare_last_words(const std::string& line,
                        const std::string& report_file,
                        const std::string& report,
                        bool is_new_file)
{
  forget_last_words();
  last_words = line;
  file_of_report = report_file;
  report_text = report;
  is_report_new = is_new_file;
  has_last_words = 1;
}

void forget_last_words()
{
  has_last_words = 0;
}

} // namespace vfc
