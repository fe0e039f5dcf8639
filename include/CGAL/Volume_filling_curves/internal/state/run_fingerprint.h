// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_RUN_FINGERPRINT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_RUN_FINGERPRINT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Run_state.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Sha256.h>
#include <CGAL/Volume_filling_curves/internal/parameters/parameter_tables.h>
#include <CGAL/Volume_filling_curves/internal/state/State_writer.h>
#include <CGAL/Volume_filling_curves/internal/text/number_text.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/version.h>

#include <cstddef>
#include <ostream>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The fingerprint of a run: by name the version, the kind of run, all parameters but those that say
// when it ends, and the hashes of curves and domain. A run resumes only if all of it is the same.
using Run_facts = std::vector<std::pair<std::string, std::string>>;

template <typename Value, typename = void>
constexpr bool has_name = false;

template <typename Value>
constexpr bool
    has_name<Value, std::void_t<decltype(std::declval<std::ostream&>() << std::declval<Value>())>> =
        std::is_enum_v<Value>;

template <typename Value>
std::string value_text(const Value& value)
{
  std::string text;
  if constexpr(std::is_floating_point_v<Value>)
    append_number(text, value);
  else if constexpr(has_name<Value>) {
    std::ostringstream out;
    out << value;
    text = out.str();
  } else if constexpr(std::is_enum_v<Value>)
    text = std::to_string(static_cast<int>(value));
  else if constexpr(std::is_integral_v<Value>)
    text = std::to_string(value);
  else if constexpr(std::is_same_v<Value, std::string>)
    text = value;
  else // a pointer or a function
    text = value ? "given" : "none";
  return text;
}

template <typename Parameters, typename Row>
void add_fact(Run_facts& facts, const Parameters& p, const Row& row)
{
  using Tag = typename Row::Tag;
  using namespace internal_np;
  if constexpr(!std::is_same_v<Tag, number_of_iterations_t> && !std::is_same_v<Tag, time_limit_t> &&
               !std::is_same_v<Tag, progress_t> && !std::is_same_v<Tag, checkpoint_t> &&
               !std::is_same_v<Tag, resume_from_t>)
    facts.emplace_back(name_of(Tag()), value_text(p.*row.member));
}

template <typename Parameters>
Run_facts run_fingerprint(const std::string& job, const Parameters& p, const Run_facts& hashes)
{
  Run_facts facts = {{"version", CGAL_VOLUME_FILLING_CURVES_VERSION}, {"job", job}};
  std::apply([&](const auto&... row) { (add_fact(facts, p, row), ...); },
             parameter_table<Parameters>());
  facts.insert(facts.end(), hashes.begin(), hashes.end());
  return facts;
}

// The hash of what a State_writer writes.
template <typename... Objects>
std::string state_hash(const Objects&... objects)
{
  State_writer writer;
  writer(objects...);
  return to_hex(sha256(writer.bytes()));
}

// Throws Run_state_error with the first fact that is another one.
inline void check_facts(const Run_facts& of_state, const Run_facts& of_run)
{
  for(std::size_t i = 0; i < of_run.size(); ++i) {
    const auto& [name, value] = of_run[i];
    if(i < of_state.size() && of_state[i] == of_run[i]) continue;
    std::string complaint = "the state is that of a run with another " + name;
    if(i < of_state.size() && value.size() < 64) // no hash
      complaint += ": " + of_state[i].second + ", not " + value;
    throw Run_state_error(complaint);
  }
}

} // namespace internal

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_RUN_FINGERPRINT_H
