// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "reports/versions.h"

#include <CGAL/Volume_filling_curves/internal/vocabulary/version.h>

#include <CGAL/version.h>
#include <CGAL/version_macros.h>

#include <Eigen/Core>
#include <boost/config.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/version.h>
#endif

namespace vfc {
namespace {

std::string eigen_version()
{
  return std::to_string(EIGEN_WORLD_VERSION) + '.' + std::to_string(EIGEN_MAJOR_VERSION) + '.' +
         std::to_string(EIGEN_MINOR_VERSION);
}

std::string tbb_version()
{
#ifdef CGAL_LINKED_WITH_TBB
  return std::to_string(TBB_VERSION_MAJOR) + '.' + std::to_string(TBB_VERSION_MINOR);
#else
  return "none";
#endif
}

std::string commit_name;

} // namespace

void set_commit(const std::string& name)
{
  commit_name = name;
}

const std::string& commit()
{
  return commit_name;
}

std::string package_version()
{
  return CGAL_VOLUME_FILLING_CURVES_VERSION;
}

std::string all_versions()
{
  return "vfc " + package_version() + (commit().empty() ? "" : "\ncommit " + commit()) +
         "\nCGAL " CGAL_VERSION_STR "\nEigen " + eigen_version() + "\nTBB " + tbb_version() +
         "\n" BOOST_COMPILER;
}

} // namespace vfc
