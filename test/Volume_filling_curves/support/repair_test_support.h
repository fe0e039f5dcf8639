// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_REPAIR_TEST_SUPPORT_H
#define VFC_TEST_REPAIR_TEST_SUPPORT_H

#include "meshes/examine_mesh.h"
#include "meshes/mesh_to_text.h"
#include "repair/repair_mesh.h"
#include "support/mesh_file_test_support.h"

#include <gtest/gtest.h>

#include <cstddef>

// Meshes in need of repair, and whether they are mended.
namespace repair_test {

using namespace mesh_file_test;

inline vfc::Mesh_soup faces_of(const Soup& soup)
{
  vfc::Mesh_soup faces;
  faces.points = soup.points;
  faces.faces = soup.faces;
  for(std::size_t f = 0; f < soup.faces.size(); ++f) faces.face_numbers.push_back(f + 1);
  return faces;
}

class Repair : public Mesh_file
{
protected:
  // mends a mesh that is not sound, into `mesh`; the result must be
  vfc::Mending mend(const Soup& soup, double alpha = 0)
  {
    const vfc::Mesh_soup faces = faces_of(soup);
    vfc::Mesh_findings findings("");
    EXPECT_FALSE(vfc::examine(faces, findings).is_valid);
    EXPECT_TRUE(findings.is_mendable());
    vfc::Work_watch no_limit;
    const vfc::Mending mending = vfc::repair_mesh(faces, alpha, mesh, no_limit);
    EXPECT_TRUE(vfc::is_sound(mesh, no_limit));
    EXPECT_FALSE(mesh.has_garbage());
    // the file of the result is as sound
    EXPECT_TRUE(read("mended.off", vfc::to_text(mesh, ".off")));
    return mending;
  }

  static bool is_wrapped(const vfc::Mending& mending)
  {
    return !mending.steps.empty() && mending.steps.back().find("wrapped") == 0;
  }
};

} // namespace repair_test

#endif // VFC_TEST_REPAIR_TEST_SUPPORT_H
