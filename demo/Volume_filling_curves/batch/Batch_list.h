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

// Reads the inputs that a shard has to do, empty lines left out. \throws Input_error if two inputs
// of the list have the same name, if one is in the folder, or has a name that is not UTF-8
std::vector<Batch_item> read_batch_list(const Batch_options& options, const std::string& folder);

} // namespace vfc

#endif // VFC_BATCH_LIST_H
