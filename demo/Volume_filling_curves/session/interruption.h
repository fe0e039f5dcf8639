// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_INTERRUPTION_H
#define VFC_INTERRUPTION_H

namespace vfc {

// A file that becomes larger than the system allows is an error like a full disk (SIGXFSZ would end
// the program and leave a part of the file). SIGINT and SIGTERM end the program at once, with the
// status for interruptions, until somebody polls: then the first signal is a request to wind up and
// save what there is, and the second one ends the program at once.

void handle_signals();
void poll_interruptions();
void ignore_polls(); // for those who lose nothing that is complete when they end at once
bool is_interruption_requested();

} // namespace vfc

#endif // VFC_INTERRUPTION_H
