// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "session/Session.h"

#include "reports/resources.h"
#include "reports/versions.h"
#include "session/Exit_status.h"
#include "session/errors.h"
#include "session/interruption.h"

#include <cstdio>
#include <utility>

namespace vfc {
namespace {

constexpr const char* last_line = "vfc: interrupted\n"; // complete files are written by then

Verbosity verbosity(const Common_options& options)
{
  if(options.is_quiet) return Verbosity::QUIET;
  return options.is_verbose ? Verbosity::VERBOSE : Verbosity::NORMAL;
}

double seconds_between(std::chrono::steady_clock::time_point from,
                       std::chrono::steady_clock::time_point to)
{
  return std::chrono::duration<double>(to - from).count();
}

} // namespace

Session::Session(const std::string& command, const Common_options& options)
    : m_options(options),
      m_console(verbosity(options)),
      m_outputs(options.may_overwrite),
      m_threads(options.threads),
      m_start_cpu_seconds(cpu_seconds())
{
  m_report["command"] = command;
  m_report["version"] = package_version();
  if(!commit().empty()) m_report["commit"] = commit();
  m_report["threads"] = m_threads.number();
  m_report["seconds_by_stage"] = Report::Json::object();
}

void Session::start_report()
{
  m_outputs.add("--report", m_options.report != "-" ? m_options.report : "");
  if(m_has_report) return; // one of several files: the session of all has prepared the last words
  m_has_report = !m_options.report.empty();
  prepare_last_words(last_line, "", "", true); // the report may still turn out to be an input
}

void Session::prepare_interruption() const
{
  Report report = m_report;
  report["status"] = "interrupted";
  report["exit_status"] = INTERRUPTED;
  prepare_last_words(last_line, m_options.report, report.to_string(),
                     Output_files::is_to_be_new(m_options.report));
}

void Session::require_output() const
{
  if(!m_outputs.is_any_named() && !m_has_report)
    throw Usage_error("no output: the result would be lost; give at least one of " +
                      m_outputs.options());
}

// While the input is checked, no report is promised: if the report would replace the input, the
// error must not be written there.
void Session::add_input(const std::string& file, const std::string& replaced_by)
{
  forget_last_words();
  const bool had_report = std::exchange(m_has_report, false);
  m_outputs.add_input(file, replaced_by);
  m_has_report = had_report;
  prepare_interruption();
}

void Session::print_result(const std::string& text) const
{
  if(m_options.report != "-") std::fwrite(text.data(), 1, text.size(), stdout);
}

void Session::print_summary(const std::string& text) const
{
  if(!m_console.is_quiet()) print_result(text);
}

double Session::end_stage(const std::string& stage)
{
  const Clock::time_point now = Clock::now();
  const double seconds = seconds_between(m_stage_start, now);
  Report::Json& sum = m_report["seconds_by_stage"][stage]; // of all files that are read, say
  sum = (sum.is_null() ? 0 : double(sum)) + seconds;
  m_stage_start = now;
  return seconds;
}

double Session::seconds() const
{
  return seconds_between(m_start, Clock::now());
}

void Session::write_report(int exit_status)
{
  m_report["exit_status"] = exit_status;
  if(!m_has_report) return;
  m_has_report = false; // one attempt only
  m_report["seconds"] = seconds();
  m_report["cpu_seconds"] = cpu_seconds() - m_start_cpu_seconds;
  if(peak_memory_bytes() > 0) m_report["peak_memory_bytes"] = peak_memory_bytes();
  if(m_options.report.empty()) return;
  forget_last_words();
  const std::string text = m_report.to_string();
  if(m_options.report == "-")
    std::fwrite(text.data(), 1, text.size(), stdout);
  else
    Output_files::write(m_options.report, text);
}

} // namespace vfc
