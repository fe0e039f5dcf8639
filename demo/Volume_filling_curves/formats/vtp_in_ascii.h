// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_VTP_IN_ASCII_H
#define VFC_VTP_IN_ASCII_H

#include "formats/Vtk_encoding.h"

#include <string>

namespace vfc {

// Returns a VTP file with the arrays that its reader wants in ASCII, so that one reader serves all
// encodings: points, cells and pins. They keep their lines; other arrays are empty. A file that is
// in ASCII comes back as it is. Linear time. \throws Encoding_error
std::string vtp_in_ascii(std::string text);

} // namespace vfc

#endif // VFC_VTP_IN_ASCII_H
