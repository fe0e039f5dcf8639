// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_READ_FINITE_FILE_H
#define VFC_READ_FINITE_FILE_H

#include <CGAL/Volume_filling_curves/internal/text/whole_files.h>

#include <filesystem>
#include <string>
#include <system_error>

namespace vfc {

// Reads a whole file or pipe, but no endless device such as /dev/zero. Returns the error, if there
// is one.
inline std::error_code read_finite_file(const std::string& file, std::string& content)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if(fs::is_character_file(status) || fs::is_block_file(status))
    return std::make_error_code(std::errc::no_such_device);
  return CGAL::Volume_filling_curves::internal::read_whole_file(file, content);
}

} // namespace vfc

#endif // VFC_READ_FINITE_FILE_H
