// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Output_files.h"

#include "errors.h"

#include <CGAL/Volume_filling_curves/internal/IO/whole_files.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace vfc {
namespace {

namespace fs = std::filesystem;
namespace files = CGAL::Volume_filling_curves::internal;

// Only trying tells whether a file can be created.
std::error_code try_to_create(const fs::path& path)
{
  fs::path written;
  std::error_code error = files::write_beside(path, "", written), ignored;
  if(!error) fs::remove(written, ignored);
  return error;
}

[[noreturn]] void refuse(const std::string& option, const std::string& path, const std::string& why)
{
  throw Usage_error(option + ": " + path + ": " + why);
}

void check_writable(const std::string& option, const fs::path& path)
{
  if(const std::error_code error = try_to_create(path))
    refuse(option, path.string(), "cannot be written: " + error.message());
}

} // namespace

void Output_files::add(const std::string& option, const std::string& path)
{
  if(path.empty()) return;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if(fs::is_directory(status)) refuse(option, path, "is a folder");
  if(fs::exists(status) && !fs::is_regular_file(status)) return;
  if(fs::exists(status) && !m_may_overwrite) refuse(option, path, "exists; --force overwrites it");
  const fs::path target = fs::exists(status) ? fs::canonical(path, error) : fs::path(path);
  check_writable(option, target);
  const std::string name = fs::weakly_canonical(fs::absolute(target), error).string();
  if(std::find(m_paths.begin(), m_paths.end(), name) != m_paths.end())
    refuse(option, path, "is also the file of another option");
  m_paths.push_back(name);
}

void Output_files::add_folder(const std::string& option, const std::string& path)
{
  if(path.empty()) return;
  std::error_code error;
  const fs::path folder(path);
  const fs::file_status status = fs::status(folder, error);
  if(!fs::exists(status)) {
    const bool has_name = folder.has_filename();
    return check_writable(option, has_name ? folder : folder.parent_path());
  }
  if(!fs::is_directory(status)) refuse(option, path, "is no folder");
  if(!fs::is_empty(folder, error) && !m_may_overwrite)
    refuse(option, path, "is not empty; --force overwrites what is there");
  check_writable(option, folder / "frame");
}

void Output_files::write(const std::string& path, const std::string& content)
{
  if(const std::error_code error = files::write_whole_file(path, content))
    throw Usage_error(path + ": cannot be written: " + error.message());
}

} // namespace vfc
