// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_MESH_FILE_TEST_SUPPORT_H
#define VFC_TEST_MESH_FILE_TEST_SUPPORT_H

#include "files/mesh_files.h"
#include "support/mesh_test_support.h"

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Files in a folder of their own, and what is read from them.
namespace mesh_file_test {

namespace fs = std::filesystem;

using Kinds = std::vector<std::string>;
using meshes::Face;
using meshes::Point;
using meshes::Soup;
using Numbers = std::vector<std::size_t>;

class Mesh_file : public testing::Test
{
protected:
  void SetUp() override
  {
    const auto* const info = testing::UnitTest::GetInstance()->current_test_info();
    m_folder = fs::temp_directory_path() / ("vfc_mesh_file_" + std::string(info->name()));
    fs::create_directories(m_folder);
  }

  void TearDown() override { fs::remove_all(m_folder); }

  std::string write(const std::string& name, const std::string& text) const
  {
    const std::string path = (m_folder / name).string();
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

  // reads the mesh in a file of the folder, and lists its defects
  bool read(const std::string& name)
  {
    vfc::Mesh_and_defects result = vfc::read_mesh_and_defects((m_folder / name).string());
    mesh = std::move(result.mesh);
    origins = std::move(result.origins);
    defects = std::move(result.defects);
    return result.is_valid;
  }

  bool read(const std::string& name, const std::string& text)
  {
    write(name, text);
    return read(name);
  }

  bool read(const Soup& soup) { return read("soup.off", to_off(soup)); }

  static std::string to_off(const Soup& soup)
  {
    std::ostringstream out;
    out.precision(17);
    out << "OFF\n" << soup.points.size() << " " << soup.faces.size() << " 0\n";
    for(const Point& p : soup.points) out << p << "\n";
    for(const Face& f : soup.faces) out << "3 " << f[0] << " " << f[1] << " " << f[2] << "\n";
    return out.str();
  }

  const vfc::Defect* find(const std::string& kind) const
  {
    const auto found = std::find_if(defects.begin(), defects.end(),
                                    [&](const vfc::Defect& d) { return d.kind == kind; });
    return found == defects.end() ? nullptr : &*found;
  }

  // the kinds of all defects, each once
  Kinds kinds() const
  {
    Kinds result;
    for(const vfc::Defect& d : defects)
      if(std::find(result.begin(), result.end(), d.kind) == result.end()) result.push_back(d.kind);
    return result;
  }

  double volume() const { return CGAL::Polygon_mesh_processing::volume(mesh); }

  fs::path m_folder;
  vfc::Mesh mesh;
  vfc::Defects defects;
  Numbers origins;
};

} // namespace mesh_file_test

#endif // VFC_TEST_MESH_FILE_TEST_SUPPORT_H
