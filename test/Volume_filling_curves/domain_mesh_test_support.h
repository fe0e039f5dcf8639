// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_DOMAIN_MESH_TEST_SUPPORT_H
#define VFC_TEST_DOMAIN_MESH_TEST_SUPPORT_H

#include "mesh_test_support.h"

#include <CGAL/Volume_filling_curves/IO/domain_mesh.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

// Files in a folder of their own, and what is read from them.
namespace domain_mesh_test {

using namespace CGAL::Volume_filling_curves;
namespace fs = std::filesystem;

using Kind = Mesh_defect_kind;
using meshes::Face;
using meshes::Mesh;
using meshes::Point;
using meshes::Soup;
using Numbers = std::vector<std::size_t>;

class Domain_mesh : public testing::Test
{
protected:
  void SetUp() override
  {
    const auto* const info = testing::UnitTest::GetInstance()->current_test_info();
    m_folder = fs::temp_directory_path() / ("vfc_domain_mesh_" + std::string(info->name()));
    fs::create_directories(m_folder);
  }

  void TearDown() override { fs::remove_all(m_folder); }

  std::string write(const std::string& name, const std::string& text) const
  {
    const std::string path = (m_folder / name).string();
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

  // reads what `text` says into `mesh` and lists its defects
  bool read(const std::string& name, const std::string& text)
  {
    return CGAL::IO::read_domain_mesh(write(name, text), mesh, defects, origins);
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

  const Mesh_defect* find(Kind kind) const
  {
    const auto found = std::find_if(defects.begin(), defects.end(),
                                    [&](const Mesh_defect& d) { return d.kind == kind; });
    return found == defects.end() ? nullptr : &*found;
  }

  // the kinds of all defects, each once
  std::vector<Kind> kinds() const
  {
    std::vector<Kind> result;
    for(const Mesh_defect& d : defects)
      if(std::find(result.begin(), result.end(), d.kind) == result.end()) result.push_back(d.kind);
    return result;
  }

  double volume() const { return CGAL::Polygon_mesh_processing::volume(mesh); }

  fs::path m_folder;
  Mesh mesh;
  std::vector<Mesh_defect> defects;
  Numbers origins;
};

} // namespace domain_mesh_test

#endif // VFC_TEST_DOMAIN_MESH_TEST_SUPPORT_H
