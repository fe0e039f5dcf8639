// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_RUN_BATCH_H
#define VFC_RUN_BATCH_H

namespace vfc {

struct Command_line;
class Session;

// Runs a command for each input of a list, or of a shard of it, that is not done yet. Processes
// that work on the same folder have different shards. A run that fails does not keep others from
// being done.
//
// The process may be killed at any moment. Files of a run are written first, each of them as a
// whole; then a line of the results says that the input is done. Whatever has no such line is done
// anew by the next process.
//
// Returns the gravest exit status of all runs of the list, or of the shard, also of earlier ones.
int run_batch(const Command_line& command_line, const Session& session);

} // namespace vfc

#endif // VFC_RUN_BATCH_H
