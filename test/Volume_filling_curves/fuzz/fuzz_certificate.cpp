// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Feeds arbitrary bytes to the readers of certificates, and operations chosen by them to the replay
// and to the guard, which must agree. Build with clang++ -fsanitize=fuzzer,address,undefined.

#include "support/certificate_test_support.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace certificate_test;
using Point = Network::Point_3;

void require(bool condition)
{
  if(!condition) std::abort();
}

// A triangle, a rod beside it, and a star with three arms.
Network start_curve()
{
  return {{Point(1, -1, 0), Point(1, 1, 0), Point(3, 0, 0), Point(0, 0, -2), Point(0, 0, 2),
           Point(2, 2, 2), Point(3, 2, 2), Point(2, 3, 2), Point(2, 2, 3)},
          {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {5, 6}, {5, 7}, {5, 8}}};
}

// A certificate in either form that is accepted comes back unchanged from the other form.
void read(const std::string& content)
{
  const Network curve = start_curve();
  try {
    const Isotopy_certificate certificate(content);
    (void)VFC::verify_certificate(certificate, curve, curve);
    require(Isotopy_certificate(certificate.text()).bytes() == certificate.bytes());
  } catch(const std::invalid_argument&) {
  }
}

// Three coordinates in one byte, 0 to 3, and all kinds of other numbers in the next ones.
internal::Position position(const std::uint8_t* data)
{
  const std::vector<double> others = {-1,        -2,     -0.,   0.5,   1e-17,
                                      1 + 1e-15, 5. / 3, 1e150, -1e17, 1e-160};
  internal::Position p;
  for(std::size_t k = 0; k < 3; ++k) {
    const std::size_t other = data[1 + k];
    p[k] = other < others.size() ? others[other] : static_cast<double>(data[0] >> 2 * k & 3);
  }
  return p;
}

std::vector<Operation> operations(const std::uint8_t* data, std::size_t size)
{
  constexpr std::size_t bytes_per_operation = 6;
  std::vector<Operation> result;
  for(; size >= bytes_per_operation; size -= bytes_per_operation, data += bytes_per_operation) {
    Operation operation;
    operation.kind = static_cast<Kind>((data[0] & 3) % 3);
    operation.node = data[0] >> 4;
    operation.other = data[1] & 15;
    operation.position = position(data + 2);
    result.push_back(operation);
  }
  return result;
}

// The replay accepts as many operations as the guard.
void compare(const std::vector<Operation>& all)
{
  const Network start = start_curve();
  Guard_replay guard(start);
  const std::size_t number = guard(all);
  const internal::Canonical_curve canonical(start), end(guard.curve());
  Pieces pieces;
  pieces.header = {canonical.points().size(), canonical.edges().size(),
                   canonical.number_of_components(), canonical.digest()};
  pieces.operations = all;
  pieces.trailer.nodes = end.points().size();
  pieces.trailer.edges = end.edges().size();
  pieces.trailer.curve = end.digest();
  const auto verdict = VFC::verify_certificate(put_together(pieces), start, guard.curve());
  require(verdict.number_of_operations == number);
  require(verdict.is_valid == (number == all.size()));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const Network curve = start_curve();
  const internal::Canonical_curve canonical(curve);
  internal::Certificate_writer writer;
  writer.write(internal::Certificate_header{canonical.points().size(), canonical.edges().size(),
                                            canonical.number_of_components(), canonical.digest()});
  read(bytes);
  read(writer.bytes() + bytes);
  read("VFC-CERT text 1\n" + bytes);
  compare(operations(data, size));
  return 0;
}
