// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/Vtk_encoding.h"

#include "formats/binary_numbers.h"

#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>
#include <CGAL/Volume_filling_curves/internal/text/number_text.h>

#include <zlib.h>

#include <algorithm>
#include <iterator>
#include <type_traits>

namespace vfc {
namespace {

namespace text_of = CGAL::Volume_filling_curves::internal;

template <typename Number>
void append_all(std::string& text, std::string_view bytes, bool is_big_endian)
{
  if(bytes.size() % sizeof(Number) != 0) throw Encoding_error("an array ends within a number");
  for(; !bytes.empty(); bytes.remove_prefix(sizeof(Number))) {
    const std::uint64_t bits = bits_of(bytes.substr(0, sizeof(Number)), is_big_endian);
    if constexpr(std::is_same_v<Number, float>)
      text_of::append_number(text, real_of<float>(static_cast<std::uint32_t>(bits)));
    else if constexpr(std::is_same_v<Number, double>)
      text_of::append_number(text, real_of<double>(bits));
    else
      text += std::to_string(static_cast<Number>(bits));
    text += ' ';
  }
}

struct Number_type
{
  std::string_view name;
  void (*append_all)(std::string& text, std::string_view bytes, bool is_big_endian);
};

constexpr Number_type number_types[] = {
    {"Int8", append_all<std::int8_t>},   {"UInt8", append_all<std::uint8_t>},
    {"Int16", append_all<std::int16_t>}, {"UInt16", append_all<std::uint16_t>},
    {"Int32", append_all<std::int32_t>}, {"UInt32", append_all<std::uint32_t>},
    {"Int64", append_all<std::int64_t>}, {"UInt64", append_all<std::uint64_t>},
    {"Float32", append_all<float>},      {"Float64", append_all<double>}};

Encoding_error cut_short()
{
  return Encoding_error("an array is longer than its data in the file");
}

// Removes so many bytes from the beginning of raw or encoded ones, in base64 with the padding
// behind them.
std::string take(std::string_view& data, std::uint64_t size, bool is_base64)
{
  const std::uint64_t length = is_base64 ? (size + 2) / 3 * 4 : size;
  if(size > data.size() || length > data.size()) throw cut_short();
  const std::string_view taken = data.substr(0, length);
  data.remove_prefix(length);
  if(!is_base64) return std::string(taken);
  std::optional<std::string> bytes = bytes_of_base64(taken);
  if(!bytes) throw Encoding_error("an array is not in base64");
  if(bytes->size() < size) throw cut_short();
  bytes->resize(size);
  return *bytes;
}

std::string inflated(std::string_view block, std::size_t size)
{
  std::string bytes(size, '\0');
  auto length = static_cast<uLongf>(size);
  const int status =
      uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length,
                 reinterpret_cast<const Bytef*>(block.data()), static_cast<uLong>(block.size()));
  if(status != Z_OK || length != size) throw Encoding_error("a compressed array is damaged");
  return bytes;
}

} // namespace

Vtk_encoding::Vtk_encoding(std::string_view header_type,
                           std::string_view byte_order,
                           std::string_view compressor,
                           std::size_t max_bytes)
    : m_max_bytes(max_bytes),
      m_is_big_endian(byte_order == "BigEndian"),
      m_is_compressed(!compressor.empty())
{
  if(header_type == "UInt64")
    m_bytes_of_size = 8;
  else if(!header_type.empty() && header_type != "UInt32")
    throw Encoding_error("sizes of arrays are UInt32 or UInt64, not " +
                         text_of::quoted(header_type));
  if(m_is_compressed && compressor != "vtkZLibDataCompressor")
    throw Encoding_error("compressed by " + text_of::quoted(compressor) +
                         ", which is not read; save without compression, or by zlib");
}

std::uint64_t Vtk_encoding::size_at(std::string_view sizes, std::size_t index) const
{
  return bits_of(sizes.substr(index * m_bytes_of_size, m_bytes_of_size), m_is_big_endian);
}

std::string Vtk_encoding::bytes(std::string_view data, bool is_base64) const
{
  std::string_view rest = data;
  const std::uint64_t first = size_at(take(rest, m_bytes_of_size, is_base64), 0);
  if(first == 0) return {};
  if(first > data.size()) throw cut_short();
  if(!m_is_compressed)
    return take(data, m_bytes_of_size + first, is_base64).erase(0, m_bytes_of_size);
  // the number of blocks, the size of the first ones, of the last one, and of each when compressed
  const std::string sizes = take(data, (3 + first) * m_bytes_of_size, is_base64);
  std::uint64_t size = 0;
  for(std::size_t i = 0; i < first; ++i) {
    const std::uint64_t size_of_block = size_at(sizes, 3 + i);
    if(size_of_block > data.size() - size) throw cut_short();
    size += size_of_block;
  }
  return inflated_blocks(sizes, take(data, size, is_base64));
}

std::string Vtk_encoding::inflated_blocks(std::string_view sizes, std::string_view blocks) const
{
  const std::uint64_t number = size_at(sizes, 0), size = size_at(sizes, 1),
                      last = size_at(sizes, 2);
  std::string bytes;
  for(std::size_t i = 0; i < number; ++i) {
    const std::uint64_t length = size_at(sizes, 3 + i);
    const std::uint64_t size_of_block = i + 1 == number && last > 0 ? last : size;
    if(size_of_block > m_max_bytes - bytes.size())
      throw Encoding_error("a compressed array has more than " + std::to_string(m_max_bytes) +
                           " bytes, which a file of this size is not expected to hold");
    bytes += inflated(blocks.substr(0, length), size_of_block);
    blocks.remove_prefix(length);
  }
  return bytes;
}

void Vtk_encoding::append_numbers(std::string& text,
                                  std::string_view bytes,
                                  std::string_view type) const
{
  const auto found = std::find_if(std::begin(number_types), std::end(number_types),
                                  [&](const Number_type& known) { return known.name == type; });
  if(found == std::end(number_types))
    throw Encoding_error(text_of::quoted(type) + " is no type of numbers");
  found->append_all(text, bytes, m_is_big_endian);
}

} // namespace vfc
