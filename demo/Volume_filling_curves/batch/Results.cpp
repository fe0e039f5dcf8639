// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "batch/Results.h"

#include "session/errors.h"

#include <cstddef>
#include <functional>

namespace vfc {
namespace {

std::size_t number_of(const std::string& input)
{
  return std::hash<std::string>()(input);
}

} // namespace

Results::Results(const std::string& path, const std::string& command)
    : m_file(path), m_command(command)
{
  read_lines();
}

bool Results::reserve(const std::string& input)
{
  if(find(input) != nullptr || !m_file.reserve(number_of(input))) return false;
  read_lines(); // another process may have done it before its number was free
  if(find(input) == nullptr) return true;
  m_file.release(number_of(input));
  return false;
}

void Results::add(const std::string& input, const Report& report)
{
  m_file.append(report.to_line());
  m_file.release(number_of(input));
  read_lines();
}

const Results::Outcome* Results::find(const std::string& input) const
{
  const auto found = m_outcomes.find(input);
  return found == m_outcomes.end() ? nullptr : &found->second;
}

void Results::read_lines()
{
  for(const std::string& line : m_file.read()) {
    ++m_number_of_lines;
    if(!read_line(line))
      throw Usage_error(m_file.path() + ':' + std::to_string(m_number_of_lines) +
                        ": is no result of vfc " + m_command);
  }
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

} // namespace vfc
