// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_MOTION_RECORD_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_MOTION_RECORD_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/Canonical_curve.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Certificate_writer.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The record of all changes of a network, part of the network itself: it does not matter which
// guard makes a change, and a copy of a network knows how it came about. Nodes are recorded under
// numbers that they keep when the network is numbered again. A motion of all nodes is recorded as
// what was certified: single moves, one after another. Constant time per change.
class Motion_record
{
  using Kind = Certificate_operation::Kind;

public:
  // \pre the curve is embedded
  template <typename Network>
  explicit Motion_record(const Network& curve)
  {
    const Canonical_curve start(curve);
    m_numbers = start.ranks();
    m_next_number = start.points().size();
    Certificate_header header;
    header.nodes = start.points().size();
    header.edges = start.edges().size();
    header.components = start.number_of_components();
    header.curve = start.digest();
    m_writer.write(header);
  }

  // Nodes that are obstacles for a while, and no part of the curve, are left out: what misses the
  // curve and them misses the curve. The new node is the last one.
  void add_obstacle() { m_numbers.push_back(obstacle); }

  template <typename Point_3>
  void move_node(std::size_t v, const Point_3& target)
  {
    if(m_numbers[v] == obstacle) return;
    Certificate_operation operation;
    operation.kind = Kind::MOVE;
    operation.node = m_numbers[v];
    operation.position = to_position(target);
    m_writer.write(operation);
  }

  // The new node is the last one.
  template <typename Point_3>
  void insert_node(std::size_t source, std::size_t target, const Point_3& position)
  {
    if(m_numbers[source] == obstacle || m_numbers[target] == obstacle) return add_obstacle();
    Certificate_operation operation;
    operation.kind = Kind::INSERT;
    operation.node = m_numbers[source];
    operation.other = m_numbers[target];
    operation.position = to_position(position);
    m_writer.write(operation);
    m_numbers.push_back(m_next_number++);
  }

  void remove_node(std::size_t v)
  {
    if(m_numbers[v] == obstacle) return;
    Certificate_operation operation;
    operation.kind = Kind::REMOVE;
    operation.node = m_numbers[v];
    m_writer.write(operation);
  }

  void scale_by_power_of_two(int exponent)
  {
    Certificate_operation operation;
    operation.kind = Kind::SCALE;
    operation.exponent = exponent;
    m_writer.write(operation);
  }

  // The nodes get new indices; `former` has the old ones.
  template <typename Index>
  void renumber(const std::vector<Index>& former)
  {
    std::vector<std::uint64_t> numbers;
    numbers.reserve(former.size());
    for(const Index v : former) numbers.push_back(m_numbers[v]);
    m_numbers = std::move(numbers);
  }

  // Returns the certificate of the motion to `curve` as it stands. \pre the record belongs to it
  template <typename Network>
  std::string certificate(const Network& curve) const
  {
    const Canonical_curve end(curve);
    Certificate_writer writer = m_writer;
    writer.write_end(end.points().size(), end.edges().size(), end.digest());
    writer.write_record_hash(sha256(writer.bytes()));
    return writer.bytes();
  }

private:
  static constexpr std::uint64_t obstacle = static_cast<std::uint64_t>(-1);

  Certificate_writer m_writer;
  std::vector<std::uint64_t> m_numbers; // of the nodes in the record
  std::uint64_t m_next_number = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_MOTION_RECORD_H
