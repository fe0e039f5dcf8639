// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Lets runs resume from states in which numbers were replaced, removed and added, and whose
// checksums are right: they refuse them, or end with an embedded curve. Build with
// clang++ -fsanitize=fuzzer,address,undefined.

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Run_state.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Sha256.h>
#include <CGAL/Volume_filling_curves/internal/state/State_reader.h>
#include <CGAL/Volume_filling_curves/internal/state/State_writer.h>
#include <CGAL/Volume_filling_curves/internal/state/run_fingerprint.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace CGAL::Volume_filling_curves;
using Network = Curve_network_3<>;
using Point = Network::Point_3;

void require(bool condition)
{
  if(!condition) std::abort();
}

constexpr std::size_t checksum_size = 32, head_size = 12, number_size = 8;

// A curve of a few edges, and how it is untangled.
struct Run
{
  std::vector<Point> points;
  bool is_closed;
  Untangling_strategy strategy;
  bool has_certificate;

  Network curve() const
  {
    std::vector<std::array<std::size_t, 2>> edges;
    for(std::size_t v = 0; v + 1 < points.size(); ++v) edges.push_back({v, v + 1});
    if(is_closed) edges.push_back({points.size() - 1, 0});
    Network curve(points, edges);
    if(!is_closed)
      for(const std::size_t end : {std::size_t(0), points.size() - 1}) curve.set_pinned(end, true);
    return curve;
  }

  Untangling_parameters parameters(Isotopy_certificate& certificate) const
  {
    Untangling_parameters parameters;
    parameters.strategy = strategy;
    parameters.thickness = 0.5;
    if(has_certificate) parameters.certificate = &certificate;
    return parameters;
  }
};

const std::vector<Point> trefoil = {{3, 0, 0.3},   {0.9, 1.5, 1},      {-0.5, 0.9, -0.3},
                                    {-2.3, 0, -1}, {-1.5, -2.6, 0.3},  {0.9, -1.5, 1},
                                    {1, 0, -0.3},  {1.1, 2, -1},       {-1.5, 2.6, 0.3},
                                    {-1.7, 0, 1},  {-0.5, -0.9, -0.3}, {1.1, -2, -1}};

const Run runs[] = {{trefoil, true, Untangling_strategy::FLOW, false},
                    {trefoil, true, Untangling_strategy::FLOW, true},
                    {trefoil, false, Untangling_strategy::FLOW, false},
                    {trefoil, true, Untangling_strategy::SEARCH, false}};

// Ends a search at once, which gives out its state then.
struct Impatient : Default_curve_flow_visitor
{
  bool on_search(const Search_progress&) { return false; }
};

std::string state_after_a_step(const Run& run)
{
  std::string bytes;
  Network curve = run.curve();
  Isotopy_certificate certificate;
  Untangling_parameters parameters = run.parameters(certificate);
  parameters.number_of_iterations = 1;
  parameters.checkpoint = [&](const Run_checkpoint& checkpoint) {
    bytes = checkpoint.state().bytes();
  };
  untangle(curve, parameters, Impatient());
  require(bytes.size() > head_size + checksum_size);
  return bytes;
}

// What stands before the numbers: the facts, of which another one makes it the state of another
// run; and these numbers.
struct Parts
{
  std::string facts, numbers;

  explicit Parts(const std::string& state)
  {
    const std::string body = state.substr(0, state.size() - checksum_size);
    internal::State_reader reader(std::string_view(body).substr(head_size));
    internal::State_writer writer;
    internal::Run_facts run_facts;
    reader(run_facts);
    writer(run_facts);
    facts = body.substr(0, head_size + writer.bytes().size());
    numbers = body.substr(facts.size());
  }
};

const Parts& parts(std::size_t run)
{
  static const std::vector<Parts> all = [] {
    std::vector<Parts> result;
    for(const Run& some : runs) result.emplace_back(state_after_a_step(some));
    return result;
  }();
  return all[run];
}

template <typename Number>
std::string bytes_of(Number number)
{
  internal::State_writer writer;
  writer(number);
  return writer.bytes();
}

// Numbers that are large, small or none.
std::string number(std::uint8_t kind, std::uint8_t value)
{
  using Limits = std::numeric_limits<double>;
  switch(kind % 8) {
  case 0:
    return bytes_of(std::uint64_t(value));
  case 1:
    return bytes_of(std::uint64_t(1) << value % 64);
  case 2:
    return bytes_of(~std::uint64_t(value));
  case 3:
    return bytes_of(Limits::quiet_NaN());
  case 4:
    return bytes_of(value % 2 == 0 ? Limits::infinity() : -Limits::infinity());
  case 5:
    return bytes_of(static_cast<double>(value) / 16 - 8);
  case 6:
    return bytes_of(value % 2 == 0 ? Limits::denorm_min() : Limits::max());
  default:
    return bytes_of(value % 2 == 0 ? 1e-9 : 1e9);
  }
}

// Four bytes each choose a place and a number that replaces the one there, or is added, or for
// which it is removed.
std::string forged(std::string numbers, const std::uint8_t* data, std::size_t size)
{
  for(; size >= 4 && !numbers.empty(); size -= 4, data += 4) {
    const std::size_t place =
        number_size * ((data[0] + 256 * std::size_t(data[1])) % (numbers.size() / number_size));
    const bool is_added = data[2] >> 4 == 14, is_removed = data[2] >> 4 == 15;
    numbers.replace(place, is_added ? 0 : number_size,
                    is_removed ? std::string() : number(data[2], data[3]));
  }
  return numbers;
}

Run_state with_checksum(std::string bytes)
{
  const auto digest = internal::sha256(bytes);
  return Run_state(bytes.append(digest.begin(), digest.end()));
}

void resume(const Run& run, const Run_state& state)
{
  constexpr double most_seconds = 0.1;
  Network curve = run.curve();
  Isotopy_certificate certificate;
  Untangling_parameters parameters = run.parameters(certificate);
  parameters.number_of_iterations = 2;
  parameters.time_limit = most_seconds;
  parameters.resume_from = &state;
  try {
    untangle(curve, parameters, Impatient());
  } catch(const Run_state_error&) {
    return;
  }
  require(is_embedded(curve));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if(size < 1) return 0;
  const std::size_t run = data[0] % std::size(runs);
  resume(runs[run],
         with_checksum(parts(run).facts + forged(parts(run).numbers, data + 1, size - 1)));
  return 0;
}
