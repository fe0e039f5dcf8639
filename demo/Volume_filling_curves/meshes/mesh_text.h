// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_MESH_TEXT_H
#define VFC_MESH_TEXT_H

#include <cstddef>
#include <string>
#include <string_view>

namespace vfc {

// The defects in the text of a mesh file.
struct Text_problem
{
  std::string kind, message;
  std::size_t line = 0;          // 0 in a binary file
  bool is_about_amounts = false; // more is announced than the file can hold
};

// returns a part of a text as it may stand in a message: short, and without bytes that are not
// ASCII
std::string in_quotes(std::string_view text);

// returns the number of the line, from 1, that a place in the text belongs to
std::size_t line_at(std::string_view text, std::size_t place);

} // namespace vfc

#endif // VFC_MESH_TEXT_H
