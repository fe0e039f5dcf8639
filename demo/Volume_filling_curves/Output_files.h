// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_OUTPUT_FILES_H
#define VFC_OUTPUT_FILES_H

#include <string>
#include <vector>

namespace vfc {

// The files that a run is going to write. They are checked before any work starts: none may exist,
// unless the user says so, and all must be writable.
class Output_files
{
public:
  explicit Output_files(bool may_overwrite) : m_may_overwrite(may_overwrite) {}

  // Checks a file, if the path is not empty; devices and pipes are welcome.
  // \throws Usage_error that names the option
  void add(const std::string& option, const std::string& path);

  // Checks a folder that is created when its first file is written. It may exist if it is empty.
  void add_folder(const std::string& option, const std::string& path);

  // Writes a complete file, or leaves what was there as it was. \throws Usage_error
  static void write(const std::string& path, const std::string& content);

private:
  bool m_may_overwrite;
  std::vector<std::string> m_paths;
};

} // namespace vfc

#endif // VFC_OUTPUT_FILES_H
