// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "session/standard_streams.h"

#include <initializer_list>

#ifndef _WIN32
#include <fcntl.h>
#include <unistd.h>
#endif

namespace vfc {

#ifndef _WIN32

void reserve_standard_streams()
{
  for(const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    const bool is_closed = ::fcntl(stream, F_GETFD) == -1;
    if(is_closed && ::open("/dev/null", O_RDONLY) != stream) return;
  }
}

#else

void reserve_standard_streams() {}

#endif

} // namespace vfc
