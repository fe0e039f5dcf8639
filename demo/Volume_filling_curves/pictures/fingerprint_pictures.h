// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_FINGERPRINT_PICTURES_H
#define VFC_FINGERPRINT_PICTURES_H

#include <CGAL/Volume_filling_curves/identify.h>

#include <string>

namespace vfc {

// Pictures of the fingerprint of an open chain (Sulkowska et al. 2012) as the bytes of a file. Each
// cell of a triangle is the section from the node of its column to the node of its row, in the
// color of its knot, paler for less frequent knots. The cell in the lower left corner is the whole
// chain. A legend names the knots. \pre the identity has a fingerprint

std::string svg_fingerprint(const CGAL::Volume_filling_curves::Chain_identity& identity);
std::string png_fingerprint(const CGAL::Volume_filling_curves::Chain_identity& identity);

} // namespace vfc

#endif // VFC_FINGERPRINT_PICTURES_H
