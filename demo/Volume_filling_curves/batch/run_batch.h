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

// Runs a command for each unfinished input of a list, or of a shard of it. Processes on the same
// folder have different shards. The batch continues after a failed run.
//
// The process may be killed at any moment. The files of a run are written first, each as a whole;
// then a line of the results marks the input as done. The next process repeats inputs without such
// a line.
//
// Returns the most severe exit status of all runs of the list, or of the shard, including earlier
// ones.
int run_batch(const Command_line& command_line, const Session& session);

} // namespace vfc

#endif // VFC_RUN_BATCH_H
