// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "batch/Shared_lines.h"

#include "session/errors.h"

#include <CGAL/Volume_filling_curves/internal/text/whole_files.h>

#include <cerrno>
#include <filesystem>
#include <limits>
#include <system_error>

#ifndef _WIN32
#include <fcntl.h>
#endif

namespace vfc {
namespace {

namespace fs = std::filesystem;
namespace files = CGAL::Volume_filling_curves::internal;

enum class Lock
{
  WAIT,
  TRY,
  RELEASE
};

// Locks a byte or releases it. Returns whether no other process has it, also where there are no
// locks.
bool lock(std::FILE* file, long byte, Lock kind)
{
#ifdef _WIN32
  return file != nullptr && byte >= 0 && kind != Lock::WAIT;
#else
  struct flock range = {};
  range.l_type = kind == Lock::RELEASE ? F_UNLCK : F_WRLCK;
  range.l_whence = SEEK_SET;
  range.l_start = byte;
  range.l_len = 1;
  int result = -1;
  do result = ::fcntl(::fileno(file), kind == Lock::WAIT ? F_SETLKW : F_SETLK, &range);
  while(result != 0 && errno == EINTR);
  return result == 0 || (errno != EACCES && errno != EAGAIN);
#endif
}

long byte_of(std::size_t number)
{
  return 1 + static_cast<long>(number % (std::numeric_limits<long>::max() - 1));
}

// As long as it exists nobody else reads or writes. This is byte 0; numbers follow.
class Turn
{
public:
  explicit Turn(std::FILE* file) : m_file(file) { lock(m_file, 0, Lock::WAIT); }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;
  ~Turn() { lock(m_file, 0, Lock::RELEASE); }

private:
  std::FILE* m_file;
};

} // namespace

Shared_lines::Shared_lines(const std::string& path)
    : m_path(path), m_file(std::fopen(path.c_str(), "a+b"))
{
  if(m_file == nullptr) fail("opened");
  std::setvbuf(m_file, nullptr, _IONBF, 0); // a line is written at once, and read as it is now
}

Shared_lines::~Shared_lines()
{
  std::fclose(m_file);
}

std::vector<std::string> Shared_lines::read()
{
  std::string text;
  {
    const Turn turn(m_file);
    text = unread_lines();
  }
  m_read += text.size();
  std::vector<std::string> lines;
  for(std::size_t begin = 0, end = 0; begin < text.size(); begin = end + 1) {
    end = text.find('\n', begin);
    lines.push_back(text.substr(begin, end - begin));
  }
  return lines;
}

void Shared_lines::append(const std::string& line)
{
  const Turn turn(m_file);
  const std::uintmax_t end = m_read + unread_lines().size();
  const std::string text = line + '\n';
  errno = 0;
  if(std::fseek(m_file, 0, SEEK_END) == 0 &&
     std::fwrite(text.data(), 1, text.size(), m_file) == text.size() && files::is_synced(m_file))
    return;
  const int cause = errno;
  std::error_code ignored;
  fs::resize_file(m_path, end, ignored); // of a full disk, say
  errno = cause;
  fail("written");
}

bool Shared_lines::reserve(std::size_t number)
{
  return lock(m_file, byte_of(number), Lock::TRY);
}

void Shared_lines::release(std::size_t number)
{
  lock(m_file, byte_of(number), Lock::RELEASE);
}

// The lines behind those that were read. Cuts off the unfinished line of a process that was killed.
std::string Shared_lines::unread_lines()
{
  std::error_code error;
  const std::uintmax_t size = fs::file_size(m_path, error);
  errno = error.value();
  if(error || size < m_read) fail("read");
  std::string text(static_cast<std::size_t>(size - m_read), '\0');
  if(std::fseek(m_file, static_cast<long>(m_read), SEEK_SET) != 0 ||
     std::fread(text.data(), 1, text.size(), m_file) != text.size())
    fail("read");
  text.erase(text.rfind('\n') + 1); // npos + 1 is 0
  if(m_read + text.size() < size) fs::resize_file(m_path, m_read + text.size(), error);
  errno = error.value();
  if(error) fail("written");
  return text;
}

void Shared_lines::fail(const std::string& what) const
{
  throw Usage_error(m_path + ": cannot be " + what + ": " + files::last_system_error().message());
}

} // namespace vfc
