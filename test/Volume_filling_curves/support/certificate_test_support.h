// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_CERTIFICATE_TEST_SUPPORT_H
#define VFC_TEST_CERTIFICATE_TEST_SUPPORT_H

#include "support/guard_test_support.h"

#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// Certificates taken to pieces and put together again, with hashes that fit, as a forger would.
namespace certificate_test {

using namespace guard_test;
namespace VFC = CGAL::Volume_filling_curves;
namespace internal = CGAL::Volume_filling_curves::internal;
using Network = VFC::Curve_network_3<>;
using Guard = VFC::Isotopy_guard_3<>;
using Operation = internal::Certificate_operation;
using Kind = Operation::Kind;
using VFC::Certificate_verdict;
using VFC::Isotopy_certificate;
using VFC::verify_certificate;

// A motion: the curves at both ends and its certificate.
struct Motion
{
  Network start, end;
  Isotopy_certificate certificate;

  Certificate_verdict verdict() const { return verify_certificate(certificate, start, end); }
};

struct Pieces
{
  internal::Certificate_header header;
  std::vector<Operation> operations;
  internal::Certificate_trailer trailer;
};

inline Pieces take_apart(const Isotopy_certificate& certificate)
{
  internal::Certificate_reader reader(certificate.bytes());
  Pieces pieces;
  pieces.header = reader.header();
  for(Operation next = reader.operation(); next.kind != Kind::END; next = reader.operation())
    pieces.operations.push_back(next);
  pieces.trailer = reader.trailer();
  return pieces;
}

inline Isotopy_certificate put_together(const Pieces& pieces)
{
  internal::Certificate_writer writer;
  writer.write(pieces.header);
  for(const Operation& operation : pieces.operations) writer.write(operation);
  writer.write_end(pieces.trailer.nodes, pieces.trailer.edges, pieces.trailer.curve);
  writer.write_record_hash(internal::sha256(writer.bytes()));
  return Isotopy_certificate(writer.bytes());
}

// The same bytes but for the last ones, which are the hash of all others.
inline Isotopy_certificate with_fitting_hash(std::string bytes)
{
  bytes.resize(bytes.size() - 32);
  for(const std::uint8_t byte : internal::sha256(bytes)) bytes += static_cast<char>(byte);
  return Isotopy_certificate(bytes);
}

// The guard's opinion: carries out the operations until one is refused, and returns how many were
// not. The numbers of nodes are those of the certificate, since no garbage is collected.
class Guard_replay
{
public:
  explicit Guard_replay(const Network& start)
      : m_curve(renumbered(start)), m_guard(m_curve), m_indices(m_curve.number_of_nodes())
  {
    for(std::size_t v = 0; v < m_curve.number_of_nodes(); ++v) m_indices[m_curve.origin(v)] = v;
  }

  std::size_t operator()(const std::vector<Operation>& operations)
  {
    for(std::size_t k = 0; k < operations.size(); ++k)
      if(!is_done(operations[k])) return k;
    return operations.size();
  }

  const Network& curve() const { return m_curve; }

private:
  // the nodes have the indices that they have in a certificate
  static Network renumbered(const Network& start)
  {
    const internal::Canonical_curve canonical(start);
    std::vector<std::array<std::size_t, 2>> edges;
    for(const auto& edge : canonical.edges()) edges.push_back({edge[0], edge[1]});
    std::vector<Network::Point_3> points;
    for(const auto& p : canonical.points()) points.emplace_back(p[0], p[1], p[2]);
    return {points, edges};
  }

  // A network is numbered along its curves; nodes that are inserted have the same number in both.
  std::size_t index(std::uint64_t number) const
  {
    if(number < m_indices.size()) return m_indices[number];
    return number < number_of_node_indices(m_curve) ? static_cast<std::size_t>(number)
                                                    : Network::null_node();
  }

  bool is_done(const Operation& operation)
  {
    const std::size_t v = index(operation.node), w = index(operation.other);
    if(v == Network::null_node() || m_curve.is_removed_node(v)) return false;
    const auto& p = operation.position;
    const Network::Point_3 point(p[0], p[1], p[2]);
    if(operation.kind == Kind::MOVE) return m_guard.move_node(v, point);
    if(operation.kind == Kind::REMOVE) return m_guard.remove_node(v);
    for(std::size_t k = 0; k < m_curve.degree(v); ++k)
      if(m_curve.neighbor(v, k) == w)
        return m_guard.insert_node(m_curve.incident_edge(v, k), point);
    return false;
  }

  Network m_curve;
  Guard m_guard;
  std::vector<std::size_t> m_indices; // of the nodes of the start
};

// The curve, all coordinates multiplied by two to the power of `exponent`.
inline Network scaled(const Network& curve, int exponent)
{
  std::vector<Network::Point_3> points;
  std::vector<std::array<std::size_t, 2>> edges;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) {
    const auto& p = curve.point(v);
    points.emplace_back(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent),
                        std::ldexp(p.z(), exponent));
  }
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
    edges.push_back({curve.source(e), curve.target(e)});
  return {points, edges};
}

// Random certified changes of all kinds.
inline void change_at_random(Guard& guard, std::size_t number, std::size_t side, Random& random)
{
  const Network& curve = guard.curve();
  for(std::size_t k = 0; k < number; ++k) {
    const std::size_t v = below(number_of_node_indices(curve), random);
    const std::size_t e = below(number_of_edge_indices(curve), random);
    const auto place = to_point(random_point(side, false, random));
    switch(below(5, random)) {
    case 0:
      if(!curve.is_removed_edge(e)) guard.insert_node(e, place);
      break;
    case 1:
      guard.remove_node(v);
      break;
    case 2: {
      guard.collect_garbage();
      const auto n = static_cast<Eigen::Index>(curve.number_of_nodes());
      Targets targets(n, 3);
      for(Eigen::Index i = 0; i < n; ++i) {
        const auto& p = curve.point(static_cast<std::size_t>(i));
        targets.row(i) << p.x(), p.y(), p.z() + static_cast<double>(below(3, random)) / 4;
      }
      guard.move_nodes(targets, 0.125);
      break;
    }
    default:
      if(!curve.is_removed_node(v)) guard.move_node(v, place);
    }
  }
  guard.collect_garbage();
}

} // namespace certificate_test

#endif // VFC_TEST_CERTIFICATE_TEST_SUPPORT_H
