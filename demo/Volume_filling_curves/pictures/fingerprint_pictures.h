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

// Pictures of the fingerprint of an open chain as the bytes of a file (Sulkowska et al. 2012): a
// triangle of cells, each a section from the node at its column to that at its row, in the color of
// its knot, the paler the less frequent the knot is; the whole chain is the cell in the lower left
// corner. A legend names the knots.
// \pre there is a fingerprint

std::string svg_fingerprint(const CGAL::Volume_filling_curves::Chain_identity& identity);
std::string png_fingerprint(const CGAL::Volume_filling_curves::Chain_identity& identity);

} // namespace vfc

#endif // VFC_FINGERPRINT_PICTURES_H
