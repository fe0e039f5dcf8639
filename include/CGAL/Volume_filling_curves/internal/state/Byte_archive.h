// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_BYTE_ARCHIVE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_BYTE_ARCHIVE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Archive that copies numbers, plain structs and arrays of these to bytes and back, as they are in
// memory. Structs must not have pointers, or members of type `bool` or `std::optional`, for which
// some bytes are invalid. (Boost.Serialization would have to be linked.) Linear time.
class Byte_archive
{
public:
  // Writes.
  Byte_archive() = default;

  // Reads. The bytes must outlive the archive.
  explicit Byte_archive(std::string_view bytes) : m_rest(bytes), m_is_reading(true) {}

  bool is_reading() const { return m_is_reading; }
  bool is_at_end() const { return m_rest.empty(); }    // of what is read
  const std::string& bytes() const { return m_bytes; } // that were written

  // Throws std::invalid_argument if there are not enough bytes, and allocates no more than they
  // fill.
  template <typename... Parts>
  void operator()(Parts&&... parts)
  {
    (copy(parts), ...);
  }

  // Throws std::invalid_argument if numbers that were read do not fit together.
  static void require(bool condition)
  {
    if(!condition) throw std::invalid_argument("numbers do not fit together");
  }

private:
  template <typename Part>
  void copy(Part& part)
  {
    if constexpr(std::is_same_v<Part, bool>) {
      auto byte = static_cast<unsigned char>(part);
      copy(byte);
      part = byte != 0;
    } else if constexpr(std::is_trivially_copyable_v<Part>)
      copy_bytes(&part, sizeof part);
    else
      copy_items(part);
  }

  // a string, a vector or a field
  template <typename Items>
  void copy_items(Items& items)
  {
    using Item = std::decay_t<decltype(*items.data())>;
    static_assert(std::is_trivially_copyable_v<Item>);
    auto size = static_cast<std::size_t>(items.size());
    copy(size);
    if(m_is_reading) {
      require(size <= m_rest.size() / sizeof(Item));
      if constexpr(std::is_same_v<Items, Vector_field>) {
        require(size % 3 == 0);
        items.resize(static_cast<Eigen::Index>(size / 3), 3);
      } else
        items.resize(size);
    }
    copy_bytes(items.data(), size * sizeof(Item));
  }

  void copy_bytes(void* part, std::size_t size)
  {
    if(!m_is_reading) {
      m_bytes.append(static_cast<const char*>(part), size);
      return;
    }
    require(size <= m_rest.size());
    if(size > 0) std::memcpy(part, m_rest.data(), size);
    m_rest.remove_prefix(size);
  }

  std::string m_bytes;
  std::string_view m_rest; // to be read
  bool m_is_reading = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_BYTE_ARCHIVE_H
