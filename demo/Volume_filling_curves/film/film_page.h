// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_FILM_PAGE_H
#define VFC_FILM_PAGE_H

#include <string>

namespace vfc {

// Returns a page that shows a film in a browser, without any other file, given the result of
// Film::to_json() and the text of three.js.
std::string film_page(const std::string& film, const std::string& three_js);

// The files of this folder that the page is made of, as texts.
extern const char* const page_html;
extern const char* const page_css;
extern const char* const page_js;

} // namespace vfc

#endif // VFC_FILM_PAGE_H
