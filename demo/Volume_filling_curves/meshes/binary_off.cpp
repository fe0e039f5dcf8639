// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/binary_off.h"

#include <cstdint>
#include <cstring>

namespace vfc {
namespace {

constexpr std::string_view magic = "OFF BINARY\n";

// Numbers of four bytes, the highest first. Past the end they are zero, and the reader has failed.
class Binary_numbers
{
public:
  explicit Binary_numbers(std::string_view bytes) : m_bytes(bytes) {}

  bool has_failed() const { return m_has_failed; }

  // returns whether as many numbers may follow
  bool can_hold(std::size_t number) const { return number <= m_bytes.size() / 4; }

  std::uint32_t whole()
  {
    if(m_bytes.size() < 4) {
      m_has_failed = true;
      return 0;
    }
    std::uint32_t number = 0;
    for(const char byte : m_bytes.substr(0, 4))
      number = number << 8 | static_cast<std::uint8_t>(byte);
    m_bytes.remove_prefix(4);
    return number;
  }

  float real()
  {
    const std::uint32_t bits = whole();
    float number = 0;
    std::memcpy(&number, &bits, sizeof(number));
    return number;
  }

  void skip(std::size_t number)
  {
    m_has_failed = m_has_failed || !can_hold(number);
    if(!m_has_failed) m_bytes.remove_prefix(4 * number);
  }

private:
  std::string_view m_bytes;
  bool m_has_failed = false;
};

} // namespace

bool is_binary_off(std::string_view text)
{
  return text.substr(0, magic.size()) == magic;
}

void read_binary_off(std::string_view text,
                     std::vector<Kernel::Point_3>& points,
                     std::vector<std::vector<std::size_t>>& polygons,
                     Mesh_findings& findings)
{
  Binary_numbers numbers(text.substr(magic.size()));
  const std::size_t vertices = numbers.whole(), faces = numbers.whole();
  numbers.whole(); // edges, which nobody counts
  if(numbers.has_failed() || !numbers.can_hold(3 * vertices) || !numbers.can_hold(faces))
    return findings.add_error("truncated file",
                              "more vertices or faces are announced than the file can hold");
  for(std::size_t v = 0; v < vertices; ++v) {
    const float x = numbers.real(), y = numbers.real(), z = numbers.real();
    points.emplace_back(x, y, z);
  }
  for(std::size_t f = 0; f < faces; ++f) {
    const std::size_t corners = numbers.whole();
    if(corners > text.size())
      return findings.add_error("bad index", "a face has " + std::to_string(corners) + " corners",
                                {0, {}, {f + 1}});
    polygons.emplace_back();
    for(std::size_t i = 0; i < corners; ++i) polygons.back().push_back(numbers.whole());
    numbers.skip(numbers.whole()); // the color
    if(numbers.has_failed())
      return findings.add_error("truncated file", "the file ends within face " +
                                                      std::to_string(f + 1) + " of " +
                                                      std::to_string(faces));
  }
}

} // namespace vfc
