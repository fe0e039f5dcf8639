// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_VERSIONS_H
#define VFC_VERSIONS_H

#include <string>

namespace vfc {

// The commit that the program was built from, empty if there was no git. main() sets it.
void set_commit(const std::string& name);
const std::string& commit();

// The version of the package, and the lines that `vfc --version` prints.
std::string package_version();
std::string all_versions();

} // namespace vfc

#endif // VFC_VERSIONS_H
