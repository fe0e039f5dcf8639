// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_FILM_H
#define VFC_FILM_H

#include "files/curve_files.h"
#include "files/mesh_files.h"
#include "pictures/Vector.h"

#include <nlohmann/json.hpp>

#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <vector>

namespace vfc {

// The content of a film, as its page expects it: an object with
//   title     a text
//   tube      the radius of the tube, in the unit of coordinates
//   colors    of components, as "#rrggbb"; they repeat
//   low, high the corners of a box that holds everything
//   frames    a list of {iteration, length, nodes, strands, points}; strands is a list of triples:
//             number of points, 1 if closed or else 0, component; points are the coordinates of all
//             strands, one after the other
//   surface   null, or {points, triangles}
// Coordinates are 32-bit numbers, indices 32-bit integers, both little-endian, in base 64. The
// input is moved and scaled so that the surface, or else the first curve, is centered at the origin
// and has a diagonal of 1: all digits are left for the shape. Lengths are the input's.
class Film
{
public:
  // Without a surface the mesh is empty.
  Film(const std::string& title, const Mesh& mesh);

  void add(std::size_t iteration, const Curve& curve);

  // Takes the radius of the tube, where 0 stands for a radius that leaves gaps between the strands
  // of the longest curve where it fills its surroundings. \pre there is a frame
  std::string to_json(double tube) const;

private:
  void choose_coordinates(const Eigen::AlignedBox3d& box);
  void append(std::vector<float>& coordinates, const Vector& p);
  double usual_tube() const;

  nlohmann::ordered_json m_json;
  Vector m_origin = Vector::Zero();
  double m_unit = 0; // 0 while coordinates have not been chosen
  // in these coordinates: of all, of the surface, and of all curves
  Eigen::AlignedBox3d m_box;
  double m_volume = 0, m_longest = 0;
};

} // namespace vfc

#endif // VFC_FILM_H
