// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "session/interruption.h"

#include "session/Exit_status.h"

#include <csignal>
#include <cstdlib>
#include <initializer_list>

namespace vfc {
namespace {

volatile std::sig_atomic_t is_polled = 0;
bool are_polls_ignored = false;
volatile std::sig_atomic_t is_requested = 0;

} // namespace

extern "C" {
static void on_interruption(int signal)
{
  if(is_polled == 0 || is_requested != 0) std::_Exit(INTERRUPTED);
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

bool is_interruption_requested()
{
  return is_requested != 0;
}

} // namespace vfc
