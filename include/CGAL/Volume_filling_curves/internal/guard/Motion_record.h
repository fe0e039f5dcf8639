// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_MOTION_RECORD_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_MOTION_RECORD_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/Canonical_curve.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Certificate_writer.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_observer_3.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Record of all changes of a network since the record's construction, as an observer of the editor.
// Recorded node numbers survive a renumbering of the network. A motion of all nodes is recorded as
// its certified moves of single nodes. Leaves added to the network are temporary obstacles and not
// part of the curve, hence omitted: a change that misses both misses the curve.
// Constant time per change.
template <typename Network>
class Motion_record final : public Curve_network_observer_3<typename Network::Traits>
{
  using Kind = Certificate_operation::Kind;
  using Base = Curve_network_observer_3<typename Network::Traits>;

public:
  using typename Base::Point_3;
  using typename Base::Rounds;

  // \pre the curve is embedded and has no garbage
  explicit Motion_record(const Network& curve) : m_curve(curve)
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

  void on_move(std::size_t v) override { record_move(v, m_curve.point(v)); }

  void on_motion(const std::vector<Point_3>& before, const Rounds& rounds) override
  {
    const std::vector<Point_3>* last = &before;
    for(const std::vector<Point_3>& positions : rounds.positions) {
      for(std::size_t k = 0; k < positions.size(); ++k) {
        const std::size_t v = rounds.is_reversed ? positions.size() - 1 - k : k;
        if(to_position((*last)[v]) != to_position(positions[v])) record_move(v, positions[v]);
      }
      last = &positions;
    }
  }

  void on_insertion(std::size_t v) override
  {
    const std::size_t a = m_curve.neighbor(v, 0), c = m_curve.neighbor(v, 1);
    if(is_obstacle(a) || is_obstacle(c)) return on_new_ray(v);
    Certificate_operation operation;
    operation.kind = Kind::INSERT;
    operation.node = m_numbers[a];
    operation.other = m_numbers[c];
    operation.position = to_position(m_curve.point(v));
    m_writer.write(operation);
    m_numbers.push_back(m_next_number++);
  }

  void on_removal(std::size_t v, std::size_t) override
  {
    if(is_obstacle(v)) return;
    Certificate_operation operation;
    operation.kind = Kind::REMOVE;
    operation.node = m_numbers[v];
    m_writer.write(operation);
  }

  void on_new_ray(std::size_t) override { m_numbers.push_back(obstacle); }

  void on_renumbering(const std::vector<std::uint32_t>& former) override
  {
    std::vector<std::uint64_t> numbers;
    numbers.reserve(former.size());
    for(const std::uint32_t v : former) numbers.push_back(m_numbers[v]);
    m_numbers = std::move(numbers);
  }

  // the numbers of the nodes in the record
  const std::vector<std::uint64_t>& numbers() const { return m_numbers; }

  // the state of the record
  auto contents()
  {
    return std::tuple_cat(m_writer.contents(), std::tie(m_numbers, m_next_number));
  }

  // Returns the certificate of the motion to the current curve.
  std::string certificate() const
  {
    const Canonical_curve end(m_curve);
    Certificate_writer writer = m_writer;
    writer.write_end(end.points().size(), end.edges().size(), end.digest());
    writer.write_record_hash(sha256(writer.bytes()));
    return writer.bytes();
  }

private:
  static constexpr std::uint64_t obstacle = static_cast<std::uint64_t>(-1);

  bool is_obstacle(std::size_t v) const { return m_numbers[v] == obstacle; }

  void record_move(std::size_t v, const Point_3& target)
  {
    if(is_obstacle(v)) return;
    Certificate_operation operation;
    operation.kind = Kind::MOVE;
    operation.node = m_numbers[v];
    operation.position = to_position(target);
    m_writer.write(operation);
  }

  const Network& m_curve;
  Certificate_writer m_writer;
  std::vector<std::uint64_t> m_numbers; // of the nodes in the record
  std::uint64_t m_next_number = 0;
};

// Writes the certificate of curves that have not changed, if one is wanted.
// \pre the network has no garbage
template <typename Network>
void certify_no_change(const Network& curves, Isotopy_certificate* certificate)
{
  if(certificate) *certificate = Isotopy_certificate(Motion_record<Network>(curves).certificate());
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_MOTION_RECORD_H
