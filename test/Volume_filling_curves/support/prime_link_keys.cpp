// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// prime_link_keys FILE: prints the header with the keys of the links in a file of braid words.

#include "support/computed_link_keys.h"

#include <cstdint>
#include <cstdio>
#include <exception>
#include <set>
#include <string>

namespace {

using namespace knot_test;

const char* const head = R"(// Copyright (c) 2026 The Volume_filling_curves authors.
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
)";

const char* const tail = R"(// clang-format on

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PRIME_LINK_KEYS_H
)";

std::string rows(const std::set<std::uint64_t>& keys, const std::string& name, bool is_mirror)
{
  std::string text;
  const std::string place{name[0], ',', ' ', name[2], ',', ' ', name[4]}; // in "6^3_1"
  for(const std::uint64_t key : keys) {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016jx", static_cast<std::uintmax_t>(key));
    text +=
        std::string("  {0x") + digits + ", " + place + (is_mirror ? ", true},\n" : ", false},\n");
  }
  return text;
}

} // namespace

int main(int argc, char** argv)
try {
  std::string text;
  std::size_t number = 0;
  for(const Named_braid& link : prime_knots(argc == 2 ? argv[1] : "")) {
    const auto keys = computed_link_keys(closure(link.braid)),
               mirror_keys = computed_link_keys(closure(mirrored(link.braid)));
    text += rows(keys, link.name, false);
    number += keys.size();
    if(mirror_keys == keys) continue;
    text += rows(mirror_keys, link.name, true);
    number += mirror_keys.size();
  }
  std::printf("%sconstexpr std::array<Prime_link_key, %zu> prime_link_keys{{\n%s}};\n%s", head,
              number, text.c_str(), tail);
} catch(const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
