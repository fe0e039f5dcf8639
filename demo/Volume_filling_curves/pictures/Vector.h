// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_VECTOR_H
#define VFC_VECTOR_H

#include "files/curve_files.h"

#include <Eigen/Geometry>

namespace vfc {

using Vector = Eigen::Vector3d;

inline Vector to_vector(const Curve::Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}

} // namespace vfc

#endif // VFC_VECTOR_H
