// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "files/Output_files.h"

#include "session/errors.h"
#include "session/interruption.h"

#include <CGAL/Volume_filling_curves/internal/text/whole_files.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>

namespace vfc {
namespace {

namespace fs = std::filesystem;
namespace files = CGAL::Volume_filling_curves::internal;

// Only an attempt shows whether a file can be created.
std::error_code try_to_create(const fs::path& path)
{
  const Complete_file scope;
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
  std::error_code error;
  const fs::path target = files::behind_links(path, error);
  if(!error) error = try_to_create(target);
  if(error) refuse(option, path.string(), "cannot be written: " + error.message());
}

// The checked outputs, files and folders, that must not replace what has appeared since the check.
std::set<fs::path>& new_outputs()
{
  static std::set<fs::path> paths;
  return paths;
}

std::set<fs::path>& written_files()
{
  static std::set<fs::path> files;
  return files;
}

// Gives a file its name, unless a file has that name. Some file systems have no hard links.
std::error_code publish(const fs::path& written, const fs::path& target)
{
  std::error_code error, ignored;
  fs::create_hard_link(written, target, error);
  if(!error) {
    fs::remove(written, ignored);
  } else if(error != std::errc::file_exists) {
    if(fs::exists(target, ignored)) return std::make_error_code(std::errc::file_exists);
    error.clear();
    fs::rename(written, target, error);
  }
  return error;
}

std::error_code write_new_file(const fs::path& path, const std::string& content)
{
  fs::path written;
  std::error_code error;
  const fs::path target = files::behind_links(path, error);
  if(!error) error = files::write_beside(target, content, written);
  if(error) return error;
  error = publish(written, target);
  if(error == std::errc::file_exists)
    throw Kept_file(path.string() + ": exists now and is not overwritten; the output is in " +
                    written.string());
  std::error_code ignored;
  if(error) fs::remove(written, ignored);
  return error;
}

// Also through links, hard links, and for files that do not exist yet.
bool are_same_file(const fs::path& a, const fs::path& b)
{
  std::error_code error;
  if(fs::equivalent(a, b, error)) return !fs::is_other(fs::status(a, error));
  const auto place = [](const fs::path& path) {
    std::error_code ignored;
    return fs::weakly_canonical(fs::absolute(files::behind_links(path, ignored)), ignored);
  };
  return !fs::exists(fs::status(a, error)) && place(a) == place(b);
}

} // namespace

void Output_files::add_input(const std::string& path, const std::string& replaced_by)
{
  for(const Output& output : m_outputs)
    if(output.option != replaced_by && are_same_file(output.path, path))
      refuse(output.option, output.path, "is the input " + path);
  m_inputs.push_back({path, replaced_by});
}

std::string Output_files::options() const
{
  std::string text;
  for(const std::string& option : m_options) text += (text.empty() ? "" : ", ") + option;
  return text;
}

// Remembers an option, and returns whether the user gave it.
bool Output_files::offer(const std::string& option, const std::string& path)
{
  if(std::find(m_options.begin(), m_options.end(), option) == m_options.end())
    m_options.push_back(option);
  m_is_any_named = m_is_any_named || !path.empty();
  return !path.empty();
}

void Output_files::check_unused(const std::string& option, const fs::path& path) const
{
  for(const Output& output : m_outputs)
    if(are_same_file(path, output.path))
      refuse(option, path.string(), "is also the file of " + output.option);
}

void Output_files::add(const std::string& option, const std::string& path)
{
  add(option, path, m_may_overwrite);
}

void Output_files::add_continued(const std::string& option,
                                 const std::string& path,
                                 const std::string& continued)
{
  const bool is_continued = !path.empty() && !continued.empty() && are_same_file(path, continued);
  add(option, path, is_continued || m_may_overwrite);
}

void Output_files::add(const std::string& option, const std::string& path, bool may_overwrite)
{
  if(!offer(option, path)) return;
  for(const Input& input : m_inputs)
    if(option != input.replaced_by && are_same_file(path, input.path))
      refuse(option, path, "is the input " + input.path);
  check_unused(option, path);
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if(fs::is_directory(status)) refuse(option, path, "is a folder");
  if(fs::exists(status) && !fs::is_regular_file(status)) return;
  if(fs::exists(status) && !may_overwrite) refuse(option, path, "exists; --force overwrites it");
  check_writable(option, path);
  if(!fs::exists(status) && !may_overwrite) new_outputs().insert(path);
  m_outputs.push_back({option, path});
}

void Output_files::add_folder(const std::string& option,
                              const std::string& path,
                              bool (*is_replaced)(const fs::path& file))
{
  if(!offer(option, path)) return;
  std::error_code error;
  const fs::path given(path), folder = given.has_filename() ? given : given.parent_path();
  const fs::file_status status = fs::status(folder, error);
  check_unused(option, folder);
  if(!m_may_overwrite) new_outputs().insert(folder);
  if(!fs::exists(status)) return check_writable(option, folder);
  if(!fs::is_directory(status)) refuse(option, path, "is not a folder");
  const auto is_there = [&](const std::string& file) {
    return is_replaced(file) && are_same_file(folder, fs::absolute(file).parent_path());
  };
  for(const Input& input : m_inputs)
    if(is_there(input.path)) refuse(option, path, "holds the input " + input.path);
  for(const Output& output : m_outputs)
    if(is_there(output.path)) refuse(option, path, "holds the file of " + output.option);
  if(!fs::is_empty(folder, error) && !m_may_overwrite)
    refuse(option, path, "is not empty; --force overwrites existing files");
  check_writable(option, folder / "frame");
}

bool Output_files::is_to_be_new(const std::string& path)
{
  const fs::path file = path;
  return written_files().count(file) == 0 &&
         new_outputs().count(file) + new_outputs().count(file.parent_path()) > 0;
}

void Output_files::write(const std::string& path, const std::string& content)
{
  std::error_code error;
  std::optional<Complete_file> scope;
  if(!fs::is_other(fs::status(path, error))) scope.emplace(); // a pipe may wait for its reader
  error =
      is_to_be_new(path) ? write_new_file(path, content) : files::write_whole_file(path, content);
  if(error) throw Usage_error(path + ": cannot be written: " + error.message());
  written_files().insert(path);
}

} // namespace vfc
