// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_VTK_ENCODING_H
#define VFC_VTK_ENCODING_H

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace vfc {

// Error in the encoding of a file's arrays.
struct Encoding_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// Encoding of arrays in VTK's XML formats, other than ASCII: bytes preceded by their number, or
// blocks compressed by zlib preceded by the sizes of all blocks; both either raw or in base64.
// Sizes are checked before memory is allocated.
class Vtk_encoding
{
public:
  // Takes the attributes of <VTKFile>, empty if absent, and the maximal number of bytes of a
  // compressed array. \throws Encoding_error
  Vtk_encoding(std::string_view header_type,
               std::string_view byte_order,
               std::string_view compressor,
               std::size_t max_bytes);

  // Returns an array that stands at the beginning of `data`. \throws Encoding_error
  std::string bytes(std::string_view data, bool is_base64) const;

  // Appends the numbers that bytes encode to a text, separated by blanks and without loss.
  // \throws Encoding_error if `type` is not one of VTK's, such as "Float32"
  void append_numbers(std::string& text, std::string_view bytes, std::string_view type) const;

private:
  std::uint64_t size_at(std::string_view sizes, std::size_t index) const;
  std::string inflated_blocks(std::string_view sizes, std::string_view blocks) const;

  std::size_t m_bytes_of_size = 4, m_max_bytes;
  bool m_is_big_endian;
  bool m_is_compressed;
};

} // namespace vfc

#endif // VFC_VTK_ENCODING_H
