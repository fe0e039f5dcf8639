// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "batch/run_batch.h"

#include "batch/Batch_list.h"
#include "batch/Results.h"
#include "options/Command_line.h"
#include "options/numbers.h"
#include "session/Exit_status.h"
#include "session/errors.h"
#include "session/interruption.h"
#include "session/run_command.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <system_error>
#include <vector>

namespace vfc {
namespace {

namespace fs = std::filesystem;

// A batch has its folder to itself, and may replace files of a killed process. Another process may
// start at the same time, whose first file is that of the results: this is looked for last.
void check_folder(const fs::path& folder, const fs::path& results, bool may_overwrite)
{
  std::error_code error;
  fs::create_directory(folder, error);
  const bool is_filled = !error && !fs::is_empty(folder, error);
  if(error)
    throw Usage_error("--output: " + folder.string() + ": is not a folder: " + error.message());
  if(is_filled && !fs::exists(results) && !may_overwrite)
    throw Usage_error("--output: " + folder.string() +
                      ": is not empty, and contains no results.jsonl of a batch; --force "
                      "overwrites existing files");
}

// Incomplete files of a killed process.
void remove_unfinished(const std::string& file)
{
  std::error_code ignored;
  for(std::size_t i = 0; fs::remove(file + ".tmp" + std::to_string(i), ignored); ++i) continue;
}

// The requested extensions of other files; empty for those not requested.
std::vector<std::string> endings_of(const File_options& files)
{
  std::vector<std::string> endings;
  for(const std::string* name : files.others) endings.push_back(*name);
  for(const std::string& ending : endings)
    if(fs::path(ending).has_parent_path())
      throw Usage_error(ending + ": is no ending of a name, which --batch wants");
  return endings;
}

// Of all files of an input.
std::vector<std::string> all_endings(const Command_line& command_line)
{
  std::vector<std::string> endings = endings_of(command_line.files);
  if(command_line.files.followers)
    for(const std::string& name : command_line.files.followers()) endings.push_back(name);
  endings.push_back(command_line.batch.format);
  endings.erase(std::remove(endings.begin(), endings.end(), ""), endings.end());
  return endings;
}

class Batch
{
public:
  Batch(const Command_line& command_line, const Session& session)
      : m_command_line(command_line),
        m_session(session),
        m_folder(*command_line.files.output),
        m_endings(endings_of(command_line.files)),
        m_items(read_batch_list(command_line.batch, m_folder, all_endings(command_line))),
        m_results_file((fs::path(m_folder) / name_of_results).string())
  {
    check_folder(m_folder, m_results_file, command_line.options.may_overwrite);
  }

  int run()
  {
    Results results(m_results_file, m_command_line.name);
    for(std::size_t i = 0; i < m_items.size(); ++i) {
      if(results.find(m_items[i].input) != nullptr) continue;
      const std::string outcome = run(m_items[i], results);
      m_session.console().note(std::to_string(i + 1) + " of " + std::to_string(m_items.size()) +
                               ": " + m_items[i].input + ": " + outcome);
    }
    return sum_up(results);
  }

private:
  // Does the same as a separate run for this input.
  std::string run(const Batch_item& item, Results& results) const
  {
    name_files(item);
    Common_options options = m_command_line.options;
    options.is_quiet = !options.is_verbose;
    options.may_overwrite = true;
    Session session(m_command_line.name, options);
    session.promise_report();
    {
      const Crash_record record = results.record_crash(report_of_crash(session.report(), item));
      run_command(session, m_command_line.command);
    }
    session.report()["input"] = item.input; // whatever else was read
    results.add(session.report());
    return results.find(item.input)->status + ", " + to_text(session.seconds()) + " s";
  }

  static Report report_of_crash(Report report, const Batch_item& item)
  {
    report["input"] = item.input;
    report.set_error("the program crashed");
    report["exit_status"] = FAILURE;
    return report;
  }

  void name_files(const Batch_item& item) const
  {
    const File_options& files = m_command_line.files;
    *files.input = item.input;
    if(const std::string& format = m_command_line.batch.format; !format.empty()) {
      *files.output = item.stem + '.' + format;
      remove_unfinished(*files.output);
    }
    for(std::size_t i = 0; i < m_endings.size(); ++i) {
      if(m_endings[i].empty()) continue;
      *files.others[i] = item.stem + '.' + m_endings[i];
      remove_unfinished(*files.others[i]);
    }
  }

  int sum_up(const Results& results) const
  {
    std::map<std::string, std::size_t> number_with_status;
    int exit_status = GOAL_REACHED;
    for(const Batch_item& item : m_items) {
      const Results::Outcome& outcome = *results.find(item.input);
      ++number_with_status[outcome.status];
      exit_status = more_severe(exit_status, outcome.exit_status);
    }
    std::string text = "runs " + std::to_string(m_items.size());
    for(const auto& [status, number] : number_with_status)
      text += ", " + status + ' ' + std::to_string(number);
    m_session.print_summary(text + ", reports in " + m_results_file + '\n');
    return exit_status;
  }

  const Command_line& m_command_line;
  const Session& m_session;
  std::string m_folder;
  std::vector<std::string> m_endings;
  std::vector<Batch_item> m_items;
  std::string m_results_file;
};

} // namespace

int run_batch(const Command_line& command_line, const Session& session)
{
  ignore_polls(); // what is complete is written, and all else begins anew
  return Batch(command_line, session).run();
}

} // namespace vfc
