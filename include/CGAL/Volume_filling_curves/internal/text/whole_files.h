// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_TEXT_WHOLE_FILES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_TEXT_WHOLE_FILES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Reading and writing of whole files. A new file in the same folder replaces the old one only once
// it is on the disk: others see the old file or the new one, never an incomplete one. Errors are
// those of the system.

inline std::error_code last_system_error()
{
  return {errno == 0 ? EIO : errno, std::generic_category()};
}

inline std::error_code read_whole_file(const std::string& filename, std::string& content)
{
  errno = 0;
  std::FILE* const file = std::fopen(filename.c_str(), "rb");
  if(file == nullptr) return last_system_error();
  std::array<char, 1 << 16> buffer;
  content.clear();
  std::size_t count = 0;
  while((count = std::fread(buffer.data(), 1, buffer.size(), file)) > 0)
    content.append(buffer.data(), count);
  const std::error_code error = std::ferror(file) ? last_system_error() : std::error_code();
  std::fclose(file);
  return error;
}

// Flushes a file to the disk, on systems that offer it. Returns whether that succeeded.
inline bool is_synced(std::FILE* file)
{
#if defined(__unix__) || defined(__APPLE__)
  return ::fsync(::fileno(file)) == 0 || errno == EINVAL; // pipes and devices do not support it
#else
  return file != nullptr;
#endif
}

// Writes to an open file and closes it.
inline std::error_code write_and_close(std::FILE* file, std::string_view content)
{
  if(file == nullptr) return last_system_error();
  errno = 0;
  const bool is_written = std::fwrite(content.data(), 1, content.size(), file) == content.size() &&
                          std::fflush(file) == 0 && is_synced(file);
  const std::error_code error = is_written ? std::error_code() : last_system_error();
  const bool is_closed = std::fclose(file) == 0;
  return is_written && !is_closed ? last_system_error() : error;
}

// Returns the path to which a file of this name is written: the target of all links, even missing.
inline std::filesystem::path behind_links(std::filesystem::path path, std::error_code& error)
{
  namespace fs = std::filesystem;
  const int max_links = 40; // a usual limit of systems; more links form a circle
  for(int i = 0; i < max_links; ++i) {
    const bool is_link = fs::is_symlink(fs::symlink_status(path, error));
    error.clear(); // a file that is missing is no error
    if(!is_link) return path;
    const fs::path link = fs::read_symlink(path, error);
    if(error) return path;
    path = link.is_absolute() ? link : path.parent_path() / link;
  }
  error = std::make_error_code(std::errc::too_many_symbolic_link_levels);
  return path;
}

// Writes a new file beside the target, and sets its name. After an error the file does not exist.
inline std::error_code write_beside(const std::filesystem::path& target,
                                    std::string_view content,
                                    std::filesystem::path& written)
{
  const int max_attempts = 100; // of names that interrupted or concurrent runs may use
  std::FILE* file = nullptr;
  for(int i = 0; i < max_attempts && file == nullptr; ++i) {
    written = target;
    written += ".tmp" + std::to_string(i);
    errno = 0;
    file = std::fopen(written.string().c_str(), "wbx"); // x: fails if the file exists
    if(file == nullptr && errno != EEXIST) break;
  }
  const std::error_code error = write_and_close(file, content);
  std::error_code ignored;
  if(error && file != nullptr) std::filesystem::remove(written, ignored); // else not ours
  return error;
}

inline std::error_code write_whole_file(const std::string& filename, std::string_view content)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(filename, error); // of a link's target
  const bool is_new = !fs::exists(status);
  // a device or a pipe must not be replaced by a file
  if(!is_new && !fs::is_regular_file(status))
    return write_and_close(std::fopen(filename.c_str(), "wb"), content);
  const fs::path target = behind_links(filename, error);
  if(error) return error;
  fs::path written;
  error = write_beside(target, content, written);
  if(error) return error;
  if(!is_new) fs::permissions(written, status.permissions(), error);
  if(!error) fs::rename(written, target, error);
  std::error_code ignored;
  if(error) fs::remove(written, ignored);
  return error;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_TEXT_WHOLE_FILES_H
