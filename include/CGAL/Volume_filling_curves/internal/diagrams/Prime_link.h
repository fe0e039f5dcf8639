// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PRIME_LINK_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PRIME_LINK_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Knot_key.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/prime_link_keys.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Link of Rolfsen's table with several components, or its mirror image, whatever the orientations
// of the components. The link of the table is the closure of a braid word in data/prime_links.txt.
// Amphichiral links are never mirrored.
struct Prime_link
{
  std::size_t crossings = 0, components = 0;
  std::size_t number = 0; // among links with as many crossings and components
  bool is_mirror = false;

  static constexpr std::size_t max_crossings = 6; // of the table

  // Returns the link that has the HOMFLY-PT polynomial with this key for some orientations; nothing
  // if the table has none.
  static std::optional<Prime_link> of(const Knot_key& key)
  {
    const auto has_key = [&](const Prime_link_key& k) { return k.key == key.bits(); };
    const auto k = std::find_if(prime_link_keys.begin(), prime_link_keys.end(), has_key);
    if(k == prime_link_keys.end()) return std::nullopt;
    return Prime_link{k->crossings, k->components, k->number, k->is_mirror};
  }

  bool is_amphichiral() const
  {
    return std::none_of(prime_link_keys.begin(), prime_link_keys.end(),
                        [this](const Prime_link_key& k) {
                          return k.is_mirror && k.crossings == crossings &&
                                 k.components == components && k.number == number;
                        });
  }

  // "6^3_1", or "6^3_1*" for the mirror image
  std::string name() const
  {
    return std::to_string(crossings) + '^' + std::to_string(components) + '_' +
           std::to_string(number) + (is_mirror ? "*" : "");
  }
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PRIME_LINK_H
