// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_VERSIONS_H
#define VFC_VERSIONS_H

#include <string>

namespace vfc {

// The name of the commit that the program was built from, with "-dirty" if sources were changed;
// empty if it is unknown, as without git. main() sets it: its file alone is compiled anew for each
// commit. States of runs store it, and are refused by other commits.
void set_commit(const std::string& name);
const std::string& commit();

// The version of the package, and the lines that `vfc --version` prints, first "vfc VERSION".
std::string package_version();
std::string all_versions();

} // namespace vfc

#endif // VFC_VERSIONS_H
