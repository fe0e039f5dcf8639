// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "batch/Batch_list.h"

#include "reports/Report.h"
#include "session/errors.h"

#include <CGAL/Volume_filling_curves/internal/text/whole_files.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <unordered_map>

namespace vfc {
namespace {

namespace fs = std::filesystem;

// Knots are kept in "knot.obj" and in "knot.polylines.txt".
std::string name_without_ending(const std::string& input)
{
  const fs::path stem = fs::path(input).stem();
  return (stem.extension() == ".polylines" ? stem.stem() : stem).string();
}

bool is_utf_8(const std::string& text)
{
  try {
    return !Report::Json(text).dump().empty();
  } catch(const Report::Json::type_error&) {
    return false;
  }
}

bool is_in_folder(const std::string& input, const fs::path& folder)
{
  std::error_code error; // a folder that does not exist yet holds nothing
  return fs::equivalent(fs::absolute(input).parent_path(), folder, error);
}

// Reads a list line by line, and collects its defects.
class List_reader
{
public:
  List_reader(const std::string& file,
              const std::string& folder,
              const std::vector<std::string>& endings)
      : m_file(file), m_folder(folder), m_endings(endings)
  {}

  std::vector<Batch_item> run()
  {
    std::string text;
    const auto cause = CGAL::Volume_filling_curves::internal::read_whole_file(m_file, text);
    if(cause) add_error("unreadable file", 0, cause.message());
    std::istringstream lines(text);
    for(std::string line; std::getline(lines, line);) {
      ++m_line;
      if(!line.empty() && line.back() == '\r') line.pop_back();
      if(!line.empty()) add(line);
    }
    if(!m_defects.empty()) throw Input_error(std::move(m_defects), "a list of inputs of a batch");
    return std::move(m_items);
  }

private:
  void add(const std::string& input)
  {
    const std::string name = name_without_ending(input);
    if(!is_utf_8(input)) add_error("name that is not UTF-8", m_line, "reports cannot contain it");
    reserve_files(input, name);
    if(is_in_folder(input, m_folder))
      add_error("input in the folder of results", m_line, input + " is in " + m_folder);
    m_items.push_back({input, (fs::path(m_folder) / name).string()});
  }

  // Notes the names of the files of an input, up to the first that is another's.
  void reserve_files(const std::string& input, const std::string& name)
  {
    for(const std::string& ending : m_endings) {
      const auto [before, is_new] = m_line_of_file.emplace(name + '.' + ending, m_line);
      if(is_new) continue;
      const std::size_t line = before->second;
      return add_error("second result of the same name", m_line,
                       "a result for " + input + " would have the name " + before->first +
                           (line == 0 ? ", as the file with the reports"
                                      : ", as one of line " + std::to_string(line)));
    }
  }

  void add_error(const std::string& kind, std::size_t line, const std::string& message)
  {
    m_defects.emplace_back(kind, true, m_file, Mesh_location{line}, message);
  }

  std::string m_file, m_folder;
  std::size_t m_line = 0;
  std::vector<std::string> m_endings;
  std::unordered_map<std::string, std::size_t> m_line_of_file = {{name_of_results, 0}};
  std::vector<Batch_item> m_items;
  Defects m_defects;
};

} // namespace

std::vector<Batch_item> read_batch_list(const Batch_options& options,
                                        const std::string& folder,
                                        const std::vector<std::string>& endings)
{
  const std::vector<Batch_item> all = List_reader(options.list, folder, endings).run();
  const std::size_t step = (std::min)(options.number_of_shards, all.size()); // cannot overflow
  std::vector<Batch_item> items;
  for(std::size_t i = options.shard - 1; i < all.size(); i += step) items.push_back(all[i]);
  return items;
}

} // namespace vfc
