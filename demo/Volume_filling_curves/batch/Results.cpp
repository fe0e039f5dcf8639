// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "batch/Results.h"

#include "session/errors.h"

#include <CGAL/Volume_filling_curves/internal/text/whole_files.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <sstream>
#include <system_error>

#ifndef _WIN32
#include <sys/file.h>
#endif

namespace vfc {
namespace {

namespace fs = std::filesystem;
namespace files = CGAL::Volume_filling_curves::internal;

// Lock of the file: while it exists, no other process reads or writes.
class Turn
{
public:
  explicit Turn(std::FILE* file) : m_file(file)
  {
#ifndef _WIN32
    while(::flock(::fileno(m_file), LOCK_EX) != 0 && errno == EINTR) continue;
#endif
  }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;
  ~Turn()
  {
#ifndef _WIN32
    ::flock(::fileno(m_file), LOCK_UN);
#endif
  }

private:
  std::FILE* m_file;
};

} // namespace

Results::Results(const std::string& path, const std::string& command)
    : m_path(path), m_command(command), m_file(std::fopen(path.c_str(), "a+b"), std::fclose)
{
  if(m_file == nullptr) fail("opened");
  std::setvbuf(m_file.get(), nullptr, _IONBF, 0); // a line is written at once
  const Turn turn(m_file.get());
  std::istringstream lines(whole_lines());
  std::size_t number = 0;
  for(std::string line; std::getline(lines, line);)
    if(++number; !read_line(line))
      throw Usage_error(m_path + ':' + std::to_string(number) + ": is no result of vfc " +
                        m_command);
}

void Results::add(const Report& report)
{
  const std::string line = report.to_line();
  append(line + '\n');
  read_line(line);
}

const Results::Outcome* Results::find(const std::string& input) const
{
  const auto found = m_outcomes.find(input);
  return found == m_outcomes.end() ? nullptr : &found->second;
}

// Returns the content of the file without an unfinished line, which a killed process left.
std::string Results::whole_lines()
{
  std::string text;
  std::error_code error = files::read_whole_file(m_path, text);
  const std::size_t size = text.size();
  text.erase(text.rfind('\n') + 1); // npos + 1 is 0
  if(!error && text.size() < size) fs::resize_file(m_path, text.size(), error);
  errno = error.value();
  if(error) fail("read");
  return text;
}

void Results::append(const std::string& text)
{
  std::FILE* const file = m_file.get();
  const Turn turn(file);
  const bool is_empty = std::fseek(file, -1, SEEK_END) != 0;
  if(!is_empty && std::fgetc(file) != '\n') whole_lines();
  std::error_code error;
  const std::uintmax_t size = fs::file_size(m_path, error);
  errno = error.value();
  if(!error && std::fseek(file, 0, SEEK_END) == 0 &&
     std::fwrite(text.data(), 1, text.size(), file) == text.size() && files::is_synced(file))
    return;
  const int cause = errno;
  if(!error) fs::resize_file(m_path, size, error); // of a full disk, say
  errno = cause;
  fail("written");
}

bool Results::read_line(const std::string& line)
{
  const Report::Json result = Report::Json::parse(line, nullptr, false);
  if(!result.is_object() || result.value("command", Report::Json()) != m_command) return false;
  const Report::Json input = result.value("input", Report::Json()),
                     status = result.value("status", Report::Json()),
                     exit_status = result.value("exit_status", Report::Json());
  if(!input.is_string() || !status.is_string() || !exit_status.is_number_integer() ||
     exit_status < 0 || exit_status > 255)
    return false;
  m_outcomes[input.get<std::string>()] = {exit_status.get<int>(), status.get<std::string>()};
  return true;
}

void Results::fail(const std::string& what) const
{
  throw Usage_error(m_path + ": cannot be " + what + ": " + files::last_system_error().message());
}

} // namespace vfc
