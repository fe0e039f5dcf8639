// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// prime_knot_keys FILE: prints the header with the keys of the knots in a file of braid words.

#include "support/computed_knot_keys.h"

#include <cstdint>
#include <cstdio>
#include <exception>
#include <vector>

namespace {

using namespace knot_test;

void print_pair(const Knot_key& key, const Knot_key& mirror)
{
  std::printf("{0x%016jx, 0x%016jx}", static_cast<std::uintmax_t>(key.bits()),
              static_cast<std::uintmax_t>(mirror.bits()));
}

const char* const head = R"(// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PRIME_KNOT_KEYS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PRIME_KNOT_KEYS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Written by scripts/prime-knot-keys. The bits of the Knot_key of each prime knot of up to 10
// crossings, in the order of Rolfsen's table, and of its mirror image.
)";

const char* const tail = R"(
} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PRIME_KNOT_KEYS_H
)";

void print_keys(const std::vector<Named_braid>& knots)
{
  std::printf("// clang-format off\n");
  std::printf("constexpr std::array<std::array<std::uint64_t, 2>, %zu> prime_knot_keys{{\n",
              knots.size());
  for(std::size_t i = 0; i < knots.size(); ++i) {
    std::printf(i % 2 == 0 ? "  " : " ");
    print_pair(computed_key(knots[i].braid), computed_key(mirrored(knots[i].braid)));
    std::printf(i % 2 == 0 && i + 1 < knots.size() ? "," : ",\n");
  }
  std::printf("}};\n// clang-format on\n");
}

// The knots whose mirror images only the third color tells apart.
void print_third_keys(const std::vector<Named_braid>& knots)
{
  std::printf(R"(
// A chiral knot that has the key of its mirror image: its index in the table, and the keys of the
// third color of both.
struct Third_knot_key
{
  std::size_t knot;
  std::array<std::uint64_t, 2> keys;
};

// clang-format off
constexpr std::array<Third_knot_key, 2> third_knot_keys{{
)");
  for(std::size_t i = 0; i < knots.size(); ++i) {
    const Braid &braid = knots[i].braid, mirror = mirrored(braid);
    if(computed_key(braid) != computed_key(mirror)) continue;
    const Knot_key key = computed_third_key(braid), mirror_key = computed_third_key(mirror);
    if(key == mirror_key) continue;
    std::printf("  {%zu, ", i);
    print_pair(key, mirror_key);
    std::printf("}, // %s\n", knots[i].name.c_str());
  }
  std::printf("}};\n// clang-format on\n");
}

} // namespace

int main(int argc, char** argv)
try {
  const auto knots = prime_knots(argc == 2 ? argv[1] : "");
  std::printf("%s", head);
  print_keys(knots);
  print_third_keys(knots);
  std::printf("%s", tail);
} catch(const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
