// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_FILM_PAGE_H
#define VFC_FILM_PAGE_H

#include <string>

namespace vfc {

// returns the text of three.js, a library for scenes in browsers, as Debian's package libjs-three
// installs it below one of $XDG_DATA_DIRS, or else as npm does below the current folder, if it is a
// single file: releases after 149 discourage this use, and those after 160 consist of several files
// \throws Usage_error with a remedy if it is missing
std::string read_three_js();

// Returns a page that shows a film in a browser, without any other file, given the result of
// Film::to_json() and the text of three.js.
std::string film_page(const std::string& film, const std::string& three_js);

// The files of this folder that the page is made of, as texts.
extern const char* const page_html;
extern const char* const page_css;
extern const char* const scene_js;
extern const char* const page_js;

} // namespace vfc

#endif // VFC_FILM_PAGE_H
