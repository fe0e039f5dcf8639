// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "film/film_page.h"

#include "session/errors.h"

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>
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

void replace_all(std::string& text, const std::string& old, const std::string& replacement)
{
  for(std::size_t i = text.find(old); i != std::string::npos;
      i = text.find(old, i + replacement.size()))
    text.replace(i, old.size(), replacement);
}

// Sequences that would end the element, or begin a comment; they only occur in texts.
std::string in_script(std::string text)
{
  replace_all(text, "</script", "<\\/script");
  replace_all(text, "<!--", "<\\!--");
  return text;
}

std::string in_json_script(std::string text)
{
  replace_all(text, "<", "\\u003c");
  return text;
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

std::string film_page(const std::string& film, const std::string& three_js)
{
  std::string scene = scene_js;
  replace_all(scene, "/* three.js */", in_script(three_js));
  const std::vector<std::pair<std::string, std::string>> parts{{"/* page.css */", page_css},
                                                               {"/* film */", in_json_script(film)},
                                                               {"/* scene.js */", scene},
                                                               {"/* page.js */", page_js}};
  const std::string html = page_html;
  std::string page;
  std::size_t last = 0;
  for(const auto& [mark, part] : parts) {
    const std::size_t next = html.find(mark, last);
    page += html.substr(last, next - last) + part;
    last = next + mark.size();
  }
  return page + html.substr(last);
}

} // namespace vfc
