// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/IO/write_png.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Volume_filling_curves::internal;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Network = CGAL::Volume_filling_curves::Curve_network_3<>;

// Decompresses blocks with fixed codes, bit by bit as RFC 1951 says.
class Inflater
{
public:
  explicit Inflater(const std::string& bytes) : m_bytes(bytes) {}

  std::string operator()()
  {
    std::string out;
    EXPECT_EQ(bits(3), 3u) << "one last block with fixed codes";
    for(unsigned symbol = next_symbol(); symbol != 256; symbol = next_symbol()) {
      if(symbol < 256) {
        out += static_cast<char>(symbol);
        continue;
      }
      const std::size_t length = next_length(symbol - 257), distance = next_distance();
      if(distance > out.size()) throw std::runtime_error("before the first byte");
      for(std::size_t i = 0; i < length; ++i) out += out[out.size() - distance];
    }
    return out;
  }

private:
  unsigned bit()
  {
    const auto byte = static_cast<unsigned char>(m_bytes.at(m_place / 8));
    return byte >> m_place++ % 8 & 1;
  }

  unsigned bits(unsigned count)
  {
    unsigned value = 0;
    for(unsigned i = 0; i < count; ++i) value |= bit() << i;
    return value;
  }

  unsigned code(unsigned count, unsigned start = 0)
  {
    for(; count > 0; --count) start = start << 1 | bit();
    return start;
  }

  unsigned next_symbol()
  {
    unsigned value = code(7);
    if(value <= 0x17) return 256 + value;
    value = code(1, value);
    if(value >= 0x30 && value <= 0xBF) return value - 0x30;
    if(value >= 0xC0 && value <= 0xC7) return 280 + value - 0xC0;
    return 144 + code(1, value) - 0x190;
  }

  std::size_t next_length(unsigned symbol)
  {
    if(symbol == 28) return 258;
    if(symbol < 8) return 3 + symbol;
    const unsigned extra = symbol / 4 - 1;
    return 3 + ((4 + symbol % 4) << extra) + bits(extra);
  }

  std::size_t next_distance()
  {
    const unsigned symbol = code(5);
    if(symbol < 4) return 1 + symbol;
    const unsigned extra = symbol / 2 - 1;
    return 1 + ((2 + symbol % 2) << extra) + bits(extra);
  }

  const std::string& m_bytes;
  std::size_t m_place = 0;
};

TEST(Deflate, is_undone_by_a_decoder)
{
  std::mt19937 random(1);
  for(const unsigned letters : {1u, 2u, 5u, 256u})
    for(const std::size_t size : {0u, 1u, 2u, 3u, 300u, 100000u}) {
      std::string text;
      while(text.size() < size) text += static_cast<char>(random() % letters);
      EXPECT_EQ(Inflater(Deflate_compressor(text)())(), text) << letters << ' ' << size;
    }
}

TEST(Deflate, finds_what_is_repeated_from_afar)
{
  std::mt19937 random(2);
  std::string text;
  while(text.size() < 30000) text += static_cast<char>(random() % 256);
  const std::string compressed = Deflate_compressor(text + text)();
  EXPECT_LT(compressed.size(), 1.1 * static_cast<double>(text.size()));
  EXPECT_EQ(Inflater(compressed)(), text + text);
}

TEST(Checksums, are_those_of_the_standards)
{
  EXPECT_EQ(crc32("123456789"), 0xCBF43926u);
  EXPECT_EQ(adler32("Wikipedia"), 0x11E60398u);
}

TEST(Png, has_the_parts_of_the_standard)
{
  const Rgb_image image{2, 1, {255, 0, 0, 0, 255, 0}};
  const std::string file = to_png(image);
  EXPECT_EQ(file.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(file.substr(12, 4), "IHDR");
  EXPECT_EQ(file.substr(16, 8), std::string("\0\0\0\2\0\0\0\1", 8));
  EXPECT_EQ(file.substr(file.size() - 8, 4), "IEND");
}

TEST(Scene_raster, meets_a_capsule_where_it_is)
{
  Scene_raster raster(40, 40);
  const Vector a(10, 20, 3), b(30, 20, 13);
  raster.add_capsule(a, b, 5, 7);
  for(std::size_t y = 0; y < 40; ++y)
    for(std::size_t x = 0; x < 40; ++x) {
      const Scene_raster::Sample& sample = raster.sample(x, y);
      const double px = static_cast<double>(x) + 0.5, py = static_cast<double>(y) + 0.5;
      double highest = -1e9; // by trying many balls
      for(int i = 0; i <= 4000; ++i) {
        const Vector c = a + i / 4000. * (b - a);
        const double rise2 = 25 - (px - c.x()) * (px - c.x()) - (py - c.y()) * (py - c.y());
        if(rise2 >= 0) highest = std::max(highest, c.z() + std::sqrt(rise2));
      }
      ASSERT_EQ(sample.has_tube(), highest > -1e9) << x << ' ' << y;
      if(!sample.has_tube()) continue;
      EXPECT_NEAR(sample.depth, highest, 1e-3);
      EXPECT_EQ(sample.component, 7u);
    }
}

TEST(Scene_raster, adds_surfaces_before_and_behind_the_tube)
{
  Scene_raster raster(20, 20);
  raster.add_capsule({10, -5, 0}, {10, 25, 0}, 3, 0);
  for(const double z : {-10., 10.}) {
    const Triangle_soup soup{{{-50, -50, z}, {100, -50, z}, {-50, 100, z}}, {{0, 1, 2}}};
    raster.add_surface(soup, std::vector<Vector>(3, Vector::UnitZ()));
  }
  const auto &on = raster.sample(10, 10), &off = raster.sample(1, 10);
  EXPECT_GT(on.in_front, 0);
  EXPECT_FLOAT_EQ(on.in_front, on.behind);
  EXPECT_FLOAT_EQ(off.in_front + off.behind, on.in_front + on.behind);
}

TEST(Write_png, does_not_depend_on_the_size)
{
  std::array<std::string, 2> pictures;
  for(std::size_t k = 0; k < 2; ++k) {
    const double s = k == 0 ? 1 : 0x1p-30;
    const Network curve({{-s, -s, 0}, {s, -s, 0}, {0, s, s}}, {{0, 1}, {1, 2}, {2, 0}});
    CGAL::Surface_mesh<Kernel::Point_3> mesh;
    CGAL::make_tetrahedron(Kernel::Point_3(-3 * s, -2 * s, -s), Kernel::Point_3(0, -2 * s, 4 * s),
                           Kernel::Point_3(3 * s, -2 * s, -s), Kernel::Point_3(0, 4 * s, 0), mesh);
    std::ostringstream out;
    EXPECT_TRUE(CGAL::IO::write_png(out, curve, mesh));
    pictures[k] = out.str();
  }
  EXPECT_GT(pictures[0].size(), 5000u);
  EXPECT_EQ(pictures[0], pictures[1]);
}

TEST(Write_png, draws_what_is_empty)
{
  std::ostringstream out;
  EXPECT_TRUE(CGAL::IO::write_png(out, Network()));
  EXPECT_EQ(out.str().substr(1, 3), "PNG");
}

} // namespace
