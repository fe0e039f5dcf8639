// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CURVE_IO_TEST_SUPPORT_H
#define VFC_CURVE_IO_TEST_SUPPORT_H

#include <CGAL/Volume_filling_curves/IO/curve_network.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

// Curves from the texts of files, and files.
namespace curve_io_test {

using namespace CGAL::Volume_filling_curves;
namespace fs = std::filesystem;

using Network = Curve_network_3<>;

struct Reading
{
  bool is_accepted = false;
  Network network;
  std::vector<Curve_defect> defects;

  // the vertices of the file along the curve
  std::vector<std::size_t> origins() const
  {
    std::vector<std::size_t> result;
    for(std::size_t v = 0; v < network.number_of_nodes(); ++v) result.push_back(network.origin(v));
    return result;
  }
};

inline Reading read(internal::Curve_draft file, Junctions junctions)
{
  Reading reading;
  reading.is_accepted =
      internal::draft_to_embedded_network(file, reading.network, reading.defects, junctions);
  return reading;
}

inline Reading read_obj(const std::string& text, Junctions junctions = Junctions::FORBIDDEN)
{
  return read(internal::read_obj(text, junctions), junctions);
}

inline Reading read_txt(const std::string& text, Junctions junctions = Junctions::FORBIDDEN)
{
  return read(internal::read_polylines_txt(text, junctions), junctions);
}

// the first error, as "LINE: MESSAGE"
inline std::string complaint(const Reading& reading)
{
  EXPECT_FALSE(reading.is_accepted);
  for(const Curve_defect& defect : reading.defects)
    if(is_error(defect.kind)) return std::to_string(defect.line) + ": " + defect.message;
  return "";
}

// A folder that disappears with its files.
class Folder
{
public:
  Folder()
  {
    static int count = 0;
    m_path =
        fs::temp_directory_path() /
        ("curve_io_test_" + std::to_string(std::random_device()()) + "_" + std::to_string(count++));
    fs::create_directory(m_path);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(m_path); }

  std::string file(const std::string& name) const { return (m_path / name).string(); }

  std::size_t number_of_files() const
  {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(m_path), fs::directory_iterator()));
  }

private:
  fs::path m_path;
};

inline std::string content(const std::string& filename)
{
  std::ifstream file(filename, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void write(const std::string& filename, const std::string& text)
{
  std::ofstream(filename, std::ios::binary) << text;
}

inline const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

} // namespace curve_io_test

#endif // VFC_CURVE_IO_TEST_SUPPORT_H
