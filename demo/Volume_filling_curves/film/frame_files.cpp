// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "film/frame_files.h"

#include "files/Frames.h"
#include "options/numbers.h"
#include "session/errors.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace vfc {

namespace fs = std::filesystem;

std::vector<Frame_file> frames_in(const std::string& folder)
{
  std::error_code error;
  std::vector<Frame_file> frames;
  fs::directory_iterator entry(folder, error);
  for(; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const fs::path file = entry->path();
    if(!Frames::is_frame(file)) continue;
    const std::string name = file.stem().string();
    unsigned long long iteration = 0;
    if(parse(name.substr(name.find('_') + 1), iteration))
      frames.push_back({static_cast<std::size_t>(iteration), file.string()});
  }
  if(error) throw Usage_error("--film: " + folder + ": cannot be read: " + error.message());
  if(frames.empty())
    throw Usage_error("--film: " + folder + ": holds no frames; --frames of untangle and fill " +
                      "writes them");
  std::sort(frames.begin(), frames.end(),
            [](const Frame_file& a, const Frame_file& b) { return a.iteration < b.iteration; });
  return frames;
}

} // namespace vfc
