// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "session/run_command.h"

#include "session/No_result.h"
#include "session/Session.h"
#include "session/errors.h"

#include <cstdio>
#include <exception>
#include <new>

namespace vfc {
namespace {

// Returns the exit status, even if the report cannot be written: there is another error to tell.
int report_failure(Session& session, Exit_status status)
{
  try {
    session.write_report(status);
  } catch(const std::exception& error) {
    session.console().fail(error.what());
  }
  return status;
}

int fail(Session& session, const No_result& end)
{
  session.report()["status"] = end.status() == INTERRUPTED ? "interrupted" : "limit";
  session.console().fail(end.what());
  return report_failure(session, end.status());
}

int fail(Session& session, const Input_error& error)
{
  print_defects(session.console(), error.defects());
  session.report().set_error(error);
  return fail(session, INVALID_INPUT, error.what());
}

} // namespace

int run_command(Session& session, const std::function<int(Session&)>& command)
{
  try {
    session.start_report();
    const int status = command(session);
    session.write_report(status);
    if(std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      throw Usage_error("standard output cannot be written");
    return status;
  } catch(const Input_error& error) {
    return fail(session, error);
  } catch(const No_result& end) {
    return fail(session, end);
  } catch(const std::bad_alloc&) {
    return fail(session, FAILURE, "there is not enough memory");
  } catch(const std::exception& error) {
    return fail(session, FAILURE, error.what());
  }
}

int fail(Session& session, Exit_status status, const std::string& message)
{
  session.console().fail(message);
  if(session.report()["status"] != "error") session.report().set_error(message);
  return report_failure(session, status);
}

} // namespace vfc
