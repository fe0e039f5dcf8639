// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_RUN_FINGERPRINT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_RUN_FINGERPRINT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/Sha256.h>
#include <CGAL/Volume_filling_curves/internal/certificate/format.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/parameters/parameter_tables.h>
#include <CGAL/Volume_filling_curves/internal/state/Byte_archive.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/version.h>

#include <cstddef>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Fingerprint of a run: lines with the version, the kind of run, all parameters except those that
// end a run, and hashes of curves and domain. A run resumes only if all lines match.

template <typename Value>
void print_value(std::ostream& out, const Value& value)
{
  constexpr bool is_function = std::is_class_v<Value> && std::is_constructible_v<bool, Value>;
  if constexpr(is_function || std::is_pointer_v<Value>)
    out << (value ? "given" : "none");
  else if constexpr(std::is_same_v<Value, Filling_start>)
    out << static_cast<int>(value);
  else
    out << value;
}

// numbers, or ports
template <typename Item>
void print_value(std::ostream& out, const std::vector<Item>& items)
{
  out << items.size();
  for(const Item& item : items)
    if constexpr(std::is_same_v<Item, double>)
      out << ' ' << item;
    else
      for(const Position& p : {to_position(item.point), item.direction})
        for(const double x : p) out << ' ' << x;
}

template <typename Parameters>
std::string run_fingerprint(const std::string& job, const Parameters& p)
{
  using namespace internal_np;
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "version " << CGAL_VOLUME_FILLING_CURVES_VERSION << "\njob " << job << '\n';
  const auto print = [&](const auto& row) {
    using Tag = typename std::decay_t<decltype(row)>::Tag;
    constexpr bool ends_run =
        std::is_same_v<Tag, number_of_iterations_t> || std::is_same_v<Tag, time_limit_t> ||
        std::is_same_v<Tag, progress_t> || std::is_same_v<Tag, checkpoint_t> ||
        std::is_same_v<Tag, resume_from_t>;
    if constexpr(!ends_run) {
      out << name_of(Tag()) << ' ';
      print_value(out, p.*row.member);
      out << '\n';
    }
  };
  std::apply([&](const auto&... row) { (print(row), ...); }, parameter_table<Parameters>());
  return out.str();
}

inline std::string hash_line(const std::string& name, const Byte_archive& content)
{
  return name + ' ' + to_hex(sha256(content.bytes())) + '\n';
}

// Returns the fingerprint of an Any_domain_3: a hash of all corners of a mesh, and of the answers
// to some random queries, by which other domains are recognized.
template <typename Domain, typename Traits>
std::string domain_line(const Domain& domain, const Traits& traits)
{
  constexpr std::size_t number_of_queries = 1000;
  Byte_archive archive;
  auto box = domain.bbox();
  archive(std::vector(domain.corners()), box);
  Random_source random(0);
  for(std::size_t k = 0; k < number_of_queries; ++k) {
    const auto p = to_point(Space<3>::random_point(box, random), traits);
    archive(domain.is_inside(p) ? double(domain.distance(p)) : -1.);
  }
  return hash_line("domain", archive);
}

// Returns the first line in which two fingerprints differ, as a complaint.
inline std::string first_difference(const std::string& of_state, const std::string& of_run)
{
  std::istringstream state(of_state), run(of_run);
  std::string former, line;
  while(std::getline(state, former) && std::getline(run, line) && former == line) {
  }
  const std::size_t end = line.find(' ');
  std::string complaint = "the state is that of a run with another " + line.substr(0, end);
  if(line.size() < end + 64 && former.size() > end) // no hash
    complaint += ":" + former.substr(end) + ", not" + line.substr(end);
  return complaint;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_RUN_FINGERPRINT_H
