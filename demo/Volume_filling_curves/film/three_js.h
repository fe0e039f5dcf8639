// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_THREE_JS_H
#define VFC_THREE_JS_H

#include <string>

namespace vfc {

// returns the text of three.js, a library for scenes in browsers, as Debian's package libjs-three
// installs it below one of $XDG_DATA_DIRS, or else as npm does below the current folder, if it is a
// single file: releases after 149 discourage this use, and those after 160 consist of several files
// \throws Usage_error with a remedy if it is missing
std::string read_three_js();

} // namespace vfc

#endif // VFC_THREE_JS_H
