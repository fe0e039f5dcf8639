// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_STATE_READER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_STATE_READER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Run_state.h>
#include <CGAL/Volume_filling_curves/internal/state/is_sequence.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Makes objects again from the bytes of a State_writer. Throws Run_state_error where there
// are not enough of them, and allocates no more than they account for.
class State_reader
{
public:
  static constexpr bool is_reading = true;

  // The bytes must outlive the reader.
  explicit State_reader(std::string_view bytes) : m_rest(bytes) {}

  template <typename... Objects>
  void operator()(Objects&... objects)
  {
    (read(objects), ...);
  }

  bool is_at_end() const { return m_rest.empty(); }

  // Throws Run_state_error if what was read does not fit together. A checksum does not keep anybody
  // from writing another one below other bytes.
  static void require(bool condition)
  {
    if(!condition) throw Run_state_error("the state contradicts itself");
  }

private:
  template <typename Object>
  void read(Object& object)
  {
    if constexpr(std::is_enum_v<Object> || std::is_integral_v<Object>)
      object = static_cast<Object>(number());
    else if constexpr(std::is_floating_point_v<Object>) {
      const std::uint64_t bits = number();
      std::memcpy(&object, &bits, sizeof bits);
    } else if constexpr(is_sequence<Object>)
      read_items(object);
    else
      object.serialize(*this);
  }

  void read(std::string& text) { text = std::string(take(size())); }

  template <typename Object>
  void read(std::optional<Object>& object)
  {
    object.reset();
    if(number() != 0) read(object.emplace());
  }

  template <typename Item, std::size_t n>
  void read(std::array<Item, n>& items)
  {
    for(Item& item : items) read(item);
  }

  template <typename First, typename Second>
  void read(std::pair<First, Second>& pair)
  {
    read(pair.first);
    read(pair.second);
  }

  template <typename Sequence>
  void read_items(Sequence& items)
  {
    items.clear();
    for(std::size_t count = size(); count > 0; --count) {
      typename Sequence::value_type item{};
      read(item);
      items.push_back(std::move(item));
    }
  }

  // a number of items, each of which takes a byte at least
  std::size_t size()
  {
    const std::uint64_t count = number();
    if(count > m_rest.size()) fail();
    return static_cast<std::size_t>(count);
  }

  std::uint64_t number()
  {
    std::uint64_t x = 0;
    int shift = 0;
    for(const char byte : take(8)) {
      x |= std::uint64_t(static_cast<unsigned char>(byte)) << shift;
      shift += 8;
    }
    return x;
  }

  std::string_view take(std::size_t count)
  {
    if(count > m_rest.size()) fail();
    const std::string_view taken = m_rest.substr(0, count);
    m_rest.remove_prefix(count);
    return taken;
  }

  [[noreturn]] static void fail() { throw Run_state_error("the state ends early"); }

  std::string_view m_rest;
};

} // namespace internal

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_STATE_READER_H
