// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "film/three_js.h"

#include "session/errors.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

namespace vfc {
namespace {

namespace fs = std::filesystem;

// Where the desktop's base directory specification has shared data.
std::vector<fs::path> data_folders()
{
  const char* const set = std::getenv("XDG_DATA_DIRS");
  std::istringstream list(set && *set ? set : "/usr/local/share:/usr/share");
  std::vector<fs::path> folders;
  for(std::string folder; std::getline(list, folder, ':');) folders.emplace_back(folder);
  return folders;
}

std::vector<fs::path> places()
{
  std::vector<fs::path> result;
  for(const fs::path& folder : data_folders())
    result.push_back(folder / "javascript" / "three" / "three.min.js");
  result.push_back(fs::path("node_modules") / "three" / "build" / "three.min.js");
  return result;
}

} // namespace

std::string read_three_js()
{
  for(const fs::path& place : places()) {
    std::ifstream file(place, std::ios::binary);
    std::ostringstream text;
    if(file && text << file.rdbuf()) return text.str();
  }
  throw Usage_error("--film: three.js, which plays the film, is missing; install Debian's "
                    "package libjs-three, or run 'npm install three@0.149' in this folder");
}

} // namespace vfc
