// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_BATCH_LIST_H
#define VFC_BATCH_LIST_H

#include "options/batch_options.h"

#include <string>
#include <vector>

namespace vfc {

// Input of a batch, and the path of its files: the folder of the batch with the name of the input,
// without its extension.
struct Batch_item
{
  std::string input, stem;
};

// name of the file with the reports in the folder of a batch
constexpr const char* name_of_results = "results.jsonl";

// Reads the inputs of a shard, without empty lines. Takes the extensions of the files for each
// input. \throws Input_error if two files of the folder, including the results, would have the same
// name, if an input is in the folder, or if its name is not UTF-8
std::vector<Batch_item> read_batch_list(const Batch_options& options,
                                        const std::string& folder,
                                        const std::vector<std::string>& endings);

} // namespace vfc

#endif // VFC_BATCH_LIST_H
