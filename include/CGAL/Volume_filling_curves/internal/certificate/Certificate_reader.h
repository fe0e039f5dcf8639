// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_CERTIFICATE_READER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_CERTIFICATE_READER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Decoder of certificates, from the first byte to the last. It returns the operations, and throws a
// Certificate_format_error for bytes that are not a certificate; every certificate has exactly one
// encoding. The verifier checks whether nodes exist and moves are safe. Constant time per
// operation.
class Certificate_reader
{
  using Kind = Certificate_operation::Kind;

public:
  explicit Certificate_reader(std::string_view bytes) : m_bytes(bytes) {}

  Certificate_header header()
  {
    if(m_bytes.substr(0, certificate_magic.size()) != certificate_magic)
      throw Certificate_format_error("this is not a certificate");
    m_next = certificate_magic.size();
    const std::uint64_t version = integer(4);
    if(version != certificate_version)
      throw Certificate_format_error("version " + std::to_string(version) +
                                     " of the format is not supported, only version " +
                                     std::to_string(certificate_version));
    Certificate_header header;
    header.nodes = integer(8);
    header.edges = integer(8);
    header.components = integer(8);
    header.curve = digest();
    return header;
  }

  Certificate_operation operation()
  {
    const std::uint64_t word = varint(), code = word & 3, rest = word >> 2;
    Certificate_operation operation;
    operation.kind = static_cast<Kind>(code);
    if(operation.kind == Kind::END) {
      if(rest > 0) throw Certificate_format_error("an operation of an unknown kind");
      return operation;
    }
    operation.node = m_last_node = m_last_node + static_cast<std::uint64_t>(from_zigzag(rest));
    if(operation.kind == Kind::INSERT)
      operation.other = operation.node + static_cast<std::uint64_t>(from_zigzag(varint()));
    if(operation.kind != Kind::REMOVE) operation.position = position();
    return operation;
  }

  // \pre the last operation was the end
  Certificate_trailer trailer()
  {
    Certificate_trailer trailer;
    trailer.operations = integer(8);
    trailer.nodes = integer(8);
    trailer.edges = integer(8);
    trailer.curve = digest();
    m_record_length = m_next;
    trailer.record = digest();
    if(m_next != m_bytes.size())
      throw Certificate_format_error("bytes follow the end of the record");
    return trailer;
  }

  // the bytes whose hash is in the trailer
  std::string_view record() const { return m_bytes.substr(0, m_record_length); }

private:
  std::uint8_t byte()
  {
    if(m_next >= m_bytes.size()) throw Certificate_format_error("the record ends too early");
    return static_cast<std::uint8_t>(m_bytes[m_next++]);
  }

  std::uint64_t integer(int size)
  {
    std::uint64_t x = 0;
    for(int k = 0; k < size; ++k) x |= static_cast<std::uint64_t>(byte()) << 8 * k;
    return x;
  }

  std::uint64_t varint()
  {
    std::uint64_t x = 0;
    for(int shift = 0; shift < 64; shift += 7) {
      const std::uint8_t next = byte();
      const std::uint64_t bits = next & 0x7f;
      if(bits << shift >> shift != bits || (next == 0 && shift > 0)) break;
      x |= bits << shift;
      if(next < 0x80) return x;
    }
    throw Certificate_format_error("a number with an invalid encoding");
  }

  Sha256::Digest digest()
  {
    Sha256::Digest digest{};
    for(std::uint8_t& next : digest) next = byte();
    return digest;
  }

  Position position()
  {
    Position position{};
    for(double& x : position) {
      const std::uint64_t bits = integer(8);
      std::memcpy(&x, &bits, sizeof x);
      if(!std::isfinite(x)) throw Certificate_format_error("a coordinate that is not finite");
    }
    return position;
  }

  std::string_view m_bytes;
  std::size_t m_next = 0, m_record_length = 0;
  std::uint64_t m_last_node = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_CERTIFICATE_READER_H
