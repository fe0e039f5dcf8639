// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PRIME_LINK_KEYS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PRIME_LINK_KEYS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// A link of Rolfsen's table, or its mirror image, and a key of its HOMFLY-PT polynomial.
struct Prime_link_key
{
  std::uint64_t key;
  std::size_t crossings, components, number;
  bool is_mirror;
};

// Written by scripts/prime-link-keys: the keys of all prime links of up to 6 crossings and several
// components, for all orientations, and of their mirror images unless these have the same.
// clang-format off
constexpr std::array<Prime_link_key, 27> prime_link_keys{{
  {0x1f694f0902c13d29, 2, 2, 1, false},
  {0x650673741afb0d2d, 2, 2, 1, false},
  {0x30d396fe25142aab, 4, 2, 1, false},
  {0x44fe064b18049d8c, 4, 2, 1, false},
  {0x263e49116a36cef5, 4, 2, 1, true},
  {0x47f2b1d16b7a5821, 4, 2, 1, true},
  {0x27fca47419ba452f, 5, 2, 1, false},
  {0x11a3b49305051521, 5, 2, 1, true},
  {0x51c1225c295bdb4a, 6, 2, 1, false},
  {0x7f247a475443a4a8, 6, 2, 1, false},
  {0x2841328350825347, 6, 2, 1, true},
  {0x61ae6c790d771880, 6, 2, 1, true},
  {0x14db785d7777203a, 6, 2, 2, false},
  {0x3d24960049843e42, 6, 2, 2, false},
  {0x2491be1242beaddc, 6, 2, 3, false},
  {0x348cf7ab126f2527, 6, 2, 3, false},
  {0x306179ef382d0084, 6, 2, 3, true},
  {0x3ddf59792ae99892, 6, 2, 3, true},
  {0x1e9d7dc37b17e235, 6, 3, 1, false},
  {0x3c8b7c7642f173be, 6, 3, 1, false},
  {0x348d16c20e0fdb09, 6, 3, 1, true},
  {0x541f08c24d7c2f62, 6, 3, 1, true},
  {0x4c35831e6403481b, 6, 3, 2, false},
  {0x2609af6f26908a1b, 6, 3, 3, false},
  {0x66bb39f73f476f21, 6, 3, 3, false},
  {0x0eadf1455db8109f, 6, 3, 3, true},
  {0x5cf4b72e34cb3000, 6, 3, 3, true},
}};
// clang-format on

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PRIME_LINK_KEYS_H
