// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_STATE_WRITER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_STATE_WRITER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/format.h>
#include <CGAL/Volume_filling_curves/internal/state/is_sequence.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Writes objects as bytes, from which State_reader makes the same again, bit for bit. A class that
// takes part has a member serialize(archive), which passes its members to archive(...) and serves
// both directions, so that these cannot get out of step. (So has Boost.Serialization, but its
// binary archives depend on the platform.) Integers, enumerations and doubles take eight bytes, the
// low ones first. Linear time.
class State_writer
{
public:
  static constexpr bool is_reading = false;

  template <typename... Objects>
  void operator()(const Objects&... objects)
  {
    (write(objects), ...);
  }

  // appends what another one has written
  void append(const std::string& bytes) { m_bytes += bytes; }

  const std::string& bytes() const { return m_bytes; }

private:
  template <typename Object>
  void write(const Object& object)
  {
    if constexpr(std::is_enum_v<Object> || std::is_integral_v<Object>)
      append_little_endian(m_bytes, static_cast<std::uint64_t>(object));
    else if constexpr(std::is_floating_point_v<Object>)
      append_little_endian(m_bytes, object);
    else if constexpr(is_sequence<Object>) {
      write(object.size());
      for(const typename Object::value_type& item : object) write(item);
    } else // which changes nothing while it writes
      const_cast<Object&>(object).serialize(*this);
  }

  void write(const std::string& text)
  {
    write(text.size());
    m_bytes += text;
  }

  template <typename Object>
  void write(const std::optional<Object>& object)
  {
    write(object.has_value());
    if(object) write(*object);
  }

  template <typename Item, std::size_t n>
  void write(const std::array<Item, n>& items)
  {
    for(const Item& item : items) write(item);
  }

  template <typename First, typename Second>
  void write(const std::pair<First, Second>& pair)
  {
    write(pair.first);
    write(pair.second);
  }

  std::string m_bytes;
};

} // namespace internal

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_STATE_WRITER_H
