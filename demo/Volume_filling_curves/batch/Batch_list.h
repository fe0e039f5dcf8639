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

// One input of a batch, and where its files go: the folder of the batch with the name of the input,
// without its ending.
struct Batch_item
{
  std::string input, stem;
};

// the name, in the folder of a batch, of the file with its reports
constexpr const char* name_of_results = "results.jsonl";

// Reads the inputs that a shard has to do, empty lines left out. Takes the endings of the files
// that each of them gets. \throws Input_error if two files of the folder would have the same name,
// that of the results included, if an input is in the folder, or has a name that is not UTF-8
std::vector<Batch_item> read_batch_list(const Batch_options& options,
                                        const std::string& folder,
                                        const std::vector<std::string>& endings);

} // namespace vfc

#endif // VFC_BATCH_LIST_H
