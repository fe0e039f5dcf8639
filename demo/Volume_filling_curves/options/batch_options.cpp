// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/batch_options.h"

#include "options/Command_line.h"
#include "options/numbers.h"

namespace vfc {
namespace {

void read_shard(const std::string& text, Batch_options& options)
{
  const std::size_t slash = text.find('/');
  unsigned long long shard = 0, number = 0;
  if(slash == std::string::npos || !parse(text.substr(0, slash), shard) ||
     !parse(text.substr(slash + 1), number) || shard < 1 || shard > number)
    throw CLI::ValidationError("--shard", "'" + text + "' is not K/N with 1 <= K <= N");
  options.shard = shard;
  options.number_of_shards = number;
}

} // namespace

void add_batch_options(CLI::App& command,
                       CLI::Option& input,
                       const File_options& files,
                       Command_line& command_line,
                       bool writes_curves)
{
  Batch_options& options = command_line.batch;
  const std::string argument = input.get_name();
  const auto start_batch = [&options, &input, &command_line, files,
                            writes_curves](const std::string& list) {
    if(list.empty()) throw CLI::ValidationError("--batch", "a value is missing");
    options.list = list;
    if(!writes_curves) options.format.clear();
    input.required(false); // is asked for only after all options were read
    command_line.files = files;
  };
  CLI::Option& batch = *command.add_option_function<std::string>(
      "--batch", start_batch,
      "a file with the name of one " + argument +
          " per line, for many runs. The output is then a folder for " +
          (writes_curves ? "NAME.obj of each of them and " : "") +
          "results.jsonl, with a report per line; runs listed there are not repeated. Options for "
          "other files then take an extension, which is appended to the input's NAME");
  batch.type_name("LIST")->excludes(&input);
  for(const char* one_for_all : {"--report", "--checkpoint", "--resume"})
    if(CLI::Option* const other = command.get_option_no_throw(one_for_all)) batch.excludes(other);
  batch.needs(command.get_option("--output"));
  command
      .add_option_function<std::string>(
          "--shard", [&options](const std::string& text) { read_shard(text, options); },
          "run only the lines K, K + N, K + 2 N, ... of LIST")
      ->type_name("K/N")
      ->needs(&batch);
  if(!writes_curves) {
    command.get_option("--output")->needs(&batch);
    return;
  }
  command
      .add_option("--format", options.format,
                  "format of the results of a batch: obj, polylines.txt, ply, vtp, vect, xyz, txt "
                  "or dat")
      ->check(CLI::IsMember({"obj", "polylines.txt", "ply", "vtp", "vect", "xyz", "txt", "dat"})
                  .description(""))
      ->capture_default_str()
      ->type_name("NAME")
      ->needs(&batch);
}

} // namespace vfc
