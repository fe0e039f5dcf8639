// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PRIME_KNOT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PRIME_KNOT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Knot_key.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/prime_knot_keys.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Knot of Rolfsen's table, or its mirror image. The knot of the table is the closure of the braid
// word of KnotInfo (data/prime_knots.txt). Amphichiral knots are never mirrored.
struct Prime_knot
{
  std::size_t index = 0; // in the table
  bool is_mirror = false;

  friend bool operator==(const Prime_knot& k, const Prime_knot& l)
  {
    return k.index == l.index && k.is_mirror == l.is_mirror;
  }
  friend bool operator<(const Prime_knot& k, const Prime_knot& l)
  {
    return k.index != l.index ? k.index < l.index : k.is_mirror < l.is_mirror;
  }

  // the name in Rolfsen's table: the crossings, and the number among knots with as many crossings
  std::array<std::size_t, 2> place() const
  {
    constexpr std::array<std::size_t, 8> counts{1, 1, 2, 3, 7, 21, 49, 165}; // from 3 crossings on
    std::size_t crossings = 3, rest = index;
    for(; rest >= counts[crossings - 3]; ++crossings) rest -= counts[crossings - 3];
    return {crossings, rest + 1};
  }

  std::size_t crossings() const { return place()[0]; }

  // "5_2", or "5_2*" for the mirror image
  std::string name() const
  {
    const auto [crossings, number] = place();
    return std::to_string(crossings) + '_' + std::to_string(number) + (is_mirror ? "*" : "");
  }

  Knot_key key() const { return Knot_key(prime_knot_keys[index][is_mirror ? 1 : 0]); }

  // Whether only the third color distinguishes the knot from its mirror image.
  const Third_knot_key* third_key() const
  {
    const auto is_this = [this](const Third_knot_key& k) { return k.knot == index; };
    const auto k = std::find_if(third_knot_keys.begin(), third_knot_keys.end(), is_this);
    return k == third_knot_keys.end() ? nullptr : &*k;
  }

  bool is_amphichiral() const
  {
    return prime_knot_keys[index][0] == prime_knot_keys[index][1] && third_key() == nullptr;
  }

  Prime_knot mirrored() const { return {index, !is_amphichiral() && !is_mirror}; }
};

inline std::vector<Prime_knot> mirrored(std::vector<Prime_knot> factors)
{
  for(Prime_knot& knot : factors) knot = knot.mirrored();
  std::sort(factors.begin(), factors.end());
  return factors;
}

// "0_1" for no factor, else "3_1#3_1*" for a connected sum.
inline std::string knot_name(const std::vector<Prime_knot>& factors)
{
  if(factors.empty()) return "0_1";
  std::string name;
  for(const Prime_knot& knot : factors) name += (name.empty() ? "" : "#") + knot.name();
  return name;
}

// The factors of knots as connected sums, by their keys.
class Prime_factors
{
public:
  // Returns the factors, sorted, with at most `max_crossings` together; nothing if no three knots
  // of the table, or fewer, have this key. Takes at most some milliseconds.
  static std::optional<std::vector<Prime_knot>> of(const Knot_key& key, std::size_t max_crossings)
  {
    Prime_factors factors;
    if(key != Knot_key() && !factors.find(key, 0, max_crossings)) return std::nullopt;
    std::sort(factors.m_factors.begin(), factors.m_factors.end());
    return std::move(factors.m_factors);
  }

private:
  static constexpr std::size_t max_factors = 3;

  struct Entry
  {
    Knot_key key, inverse;
    Prime_knot knot;
    std::size_t crossings;
  };

  // in the table's order
  static const std::vector<Entry>& entries()
  {
    static const std::vector<Entry> all = [] {
      std::vector<Entry> entries;
      for(std::size_t i = 0; i < prime_knot_keys.size(); ++i)
        for(const bool is_mirror : {false, true}) {
          const Prime_knot knot{i, is_mirror};
          if(is_mirror && prime_knot_keys[i][0] == prime_knot_keys[i][1]) continue;
          entries.push_back({knot.key(), knot.key().inverse(), knot, knot.crossings()});
        }
      return entries;
    }();
    return all;
  }

  static const std::vector<Entry>& sorted_entries()
  {
    static const std::vector<Entry> all = [] {
      std::vector<Entry> sorted = entries();
      std::sort(sorted.begin(), sorted.end(),
                [](const Entry& e, const Entry& f) { return e.key < f.key; });
      return sorted;
    }();
    return all;
  }

  static const Entry* entry(const Knot_key& key)
  {
    const auto& all = sorted_entries();
    const auto e = std::lower_bound(all.begin(), all.end(), key,
                                    [](const Entry& f, const Knot_key& k) { return f.key < k; });
    return e == all.end() || e->key != key ? nullptr : &*e;
  }

  // The key's factors from an entry on.
  bool find(const Knot_key& key, std::size_t first, std::size_t max_crossings)
  {
    const Entry* prime = entry(key);
    if(prime && prime->crossings <= max_crossings) {
      m_factors.push_back(prime->knot);
      return true;
    }
    if(m_factors.size() + 1 == max_factors) return false;
    for(std::size_t i = first; i < entries().size(); ++i) {
      const Entry& e = entries()[i];
      if(2 * e.crossings > max_crossings) break; // the others have no fewer
      m_factors.push_back(e.knot);
      if(find(key * e.inverse, i, max_crossings - e.crossings)) return true;
      m_factors.pop_back();
    }
    return false;
  }

  std::vector<Prime_knot> m_factors;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PRIME_KNOT_H
