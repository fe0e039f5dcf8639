// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_OUTPUT_FILES_H
#define VFC_OUTPUT_FILES_H

#include <filesystem>
#include <string>
#include <vector>

namespace vfc {

// Output files of a run, checked before any work starts: none may exist, unless the user allows it,
// all must be writable, and no two names may refer to the same file. An output must not be an input
// of the run, except for a result that replaces the input, which is written long after the input is
// read.
class Output_files
{
public:
  explicit Output_files(bool may_overwrite) : m_may_overwrite(may_overwrite) {}

  // Adds an input file, and the option that may replace it, if any. \throws Usage_error if another
  // option would replace it
  void add_input(const std::string& path, const std::string& replaced_by = "");

  // Checks a file, if the path is not empty; devices and pipes are allowed. \throws Usage_error
  // that names the option
  void add(const std::string& option, const std::string& path);

  // Checks a file that the run replaces by newer ones, and that may exist if the run resumes from
  // it.
  void add_continued(const std::string& option,
                     const std::string& path,
                     const std::string& continued);

  // Checks a folder that is created when its first file is written. It may exist if it is empty, or
  // if the files there that are replaced, `is_replaced(path)`, are nobody else's. Call it after
  // all files have been added: it compares the folder with them.
  void add_folder(const std::string& option,
                  const std::string& path,
                  bool (*is_replaced)(const std::filesystem::path& file));

  // Returns whether the user named any file or folder.
  bool is_any_named() const { return m_is_any_named; }

  // Returns the checked options that name outputs: "--output, --map".
  std::string options() const;

  // Writes a complete file, or leaves the old one unchanged. A file that has appeared since the
  // checks, such as that of another run, is not overwritten. \throws Usage_error, and Kept_file
  static void write(const std::string& path, const std::string& content);

  // Returns whether a checked file, or one in a checked folder, did not exist and has not been
  // written since: if it exists now, it is another run's, and must not be replaced.
  static bool is_to_be_new(const std::string& path);

private:
  struct Input
  {
    std::string path, replaced_by;
  };

  struct Output
  {
    std::string option, path;
  };

  void add(const std::string& option, const std::string& path, bool may_overwrite);
  bool offer(const std::string& option, const std::string& path);
  void check_unused(const std::string& option, const std::filesystem::path& path) const;

  bool m_may_overwrite;
  bool m_is_any_named = false;
  std::vector<std::string> m_options; // also those without a path
  std::vector<Input> m_inputs;
  std::vector<Output> m_outputs;
};

} // namespace vfc

#endif // VFC_OUTPUT_FILES_H
