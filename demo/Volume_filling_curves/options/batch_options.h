// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_BATCH_OPTIONS_H
#define VFC_BATCH_OPTIONS_H

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace vfc {

struct Command_line;

// Many runs of one command, or the K-th of N shards of them.
struct Batch_options
{
  std::string list; // a file with the name of an input in each line, or empty for a single run
  std::string format = "obj"; // of the curves, or empty if the command writes none
  std::size_t shard = 1, number_of_shards = 1;
};

// The options of a command that a batch sets anew for each run. The others are endings of names
// in a batch.
struct File_options
{
  std::string *input = nullptr, *output = nullptr;
  std::vector<std::string*> others;
  // further files whose names follow from them; may be empty
  std::function<std::vector<std::string>()> followers = nullptr;
};

// Lets a command run in batches. The option `input` of the command is no longer required then. A
// command that writes no curves has an output only in batches: the folder with the reports.
void add_batch_options(CLI::App& command,
                       CLI::Option& input,
                       const File_options& files,
                       Command_line& command_line,
                       bool writes_curves = true);

} // namespace vfc

#endif // VFC_BATCH_OPTIONS_H
