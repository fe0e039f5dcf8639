// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_CERTIFICATE_WRITER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_CERTIFICATE_WRITER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/format.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Encoder of certificates: constant time per operation, 25 to 27 bytes per moved node. Most of
// these are coordinates, whose low bits are nearly random. Storing only the bytes that changed
// would save an eighth (Freedman-He-Wang's unknot, 2026-11-21), too little for a more complicated
// format.
class Certificate_writer
{
  using Kind = Certificate_operation::Kind;

public:
  void write(const Certificate_header& header)
  {
    m_bytes += certificate_magic;
    append_little_endian(m_bytes, certificate_version, 4);
    append_little_endian(m_bytes, header.nodes);
    append_little_endian(m_bytes, header.edges);
    append_little_endian(m_bytes, header.components);
    append(header.curve);
  }

  void write(const Certificate_operation& operation)
  {
    ++m_number_of_operations;
    append_code(difference(operation.node, m_last_node), operation.kind);
    if(operation.kind == Kind::INSERT) append_varint(difference(operation.other, operation.node));
    if(operation.kind != Kind::REMOVE) append(operation.position);
    m_last_node = operation.node;
  }

  // Writes the trailer except for its last entry, the hash of the record itself.
  void write_end(std::uint64_t nodes, std::uint64_t edges, const Sha256::Digest& curve)
  {
    append_code(0, Kind::END);
    append_little_endian(m_bytes, m_number_of_operations);
    append_little_endian(m_bytes, nodes);
    append_little_endian(m_bytes, edges);
    append(curve);
  }

  void write_record_hash(const Sha256::Digest& record) { append(record); }

  std::uint64_t number_of_operations() const { return m_number_of_operations; }
  const std::string& bytes() const { return m_bytes; }

  // all members, for a run state
  auto contents() { return std::tie(m_bytes, m_number_of_operations, m_last_node); }

private:
  static std::uint64_t difference(std::uint64_t node, std::uint64_t from)
  {
    return zigzag(static_cast<std::int64_t>(node - from));
  }

  // seven bits per byte, the low ones first; all bytes but the last have their highest bit set
  void append_varint(std::uint64_t x)
  {
    for(; x >= 0x80; x >>= 7) m_bytes += static_cast<char>((x & 0x7f) | 0x80);
    m_bytes += static_cast<char>(x);
  }

  void append_code(std::uint64_t x, Kind kind)
  {
    append_varint(x << 2 | static_cast<std::uint64_t>(kind));
  }

  void append(const Sha256::Digest& digest)
  {
    for(const std::uint8_t byte : digest) m_bytes += static_cast<char>(byte);
  }

  void append(const Position& position)
  {
    for(const double x : position) append_little_endian(m_bytes, x);
  }

  std::string m_bytes;
  std::uint64_t m_number_of_operations = 0, m_last_node = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_CERTIFICATE_WRITER_H
