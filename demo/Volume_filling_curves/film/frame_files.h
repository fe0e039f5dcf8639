// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_FRAME_FILES_H
#define VFC_FRAME_FILES_H

#include <cstddef>
#include <string>
#include <vector>

namespace vfc {

struct Frame_file
{
  std::size_t iteration;
  std::string file;
};

// Returns the frames of a run in a folder, in order. \throws Usage_error if there are none
std::vector<Frame_file> frames_in(const std::string& folder);

} // namespace vfc

#endif // VFC_FRAME_FILES_H
