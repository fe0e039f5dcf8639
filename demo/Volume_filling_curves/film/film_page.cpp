// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "film/film_page.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace vfc {
namespace {

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

std::string film_page(const std::string& film, const std::string& three_js)
{
  const std::vector<std::pair<std::string, std::string>> parts{
      {"/* page.css */", page_css},
      {"/* three.js */", in_script(three_js)},
      {"/* film */", in_json_script(film)},
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
