// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_FRAMES_H
#define VFC_FRAMES_H

#include "files/curve_files.h"
#include "options/shared_options.h"

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace vfc {

class Console;

// Frames of a film: the curve of every K-th iteration and the result, frame_000000.obj and so on;
// .vtp files also get a list, frames.pvd, for ParaView. The first one that cannot be written ends
// them with a warning: the run and its result are worth more.
class Frames
{
public:
  // Writes nothing if there is no folder. The frames of an earlier run are removed when the first
  // new one is written.
  Frames(const Film_options& options, const Console& console)
      : m_options(options), m_console(console), m_are_wanted(!options.frames.empty())
  {}

  void add(std::size_t iteration, const Curve& curve);

  // Writes the result, which may differ from the curve after the last iteration, as the last frame,
  // and the list, if there is one.
  void finish(std::size_t iteration, const Curve& curve);

  // Returns whether a file name is that of a frame of an earlier run.
  static bool is_frame(const std::filesystem::path& file);

private:
  template <typename Write>
  void warn_of_failure(const Write& write);
  void write(std::size_t iteration, const Curve& curve);
  void write_list() const;
  void prepare_folder() const;
  std::string name(std::size_t iteration) const;

  Film_options m_options;
  const Console& m_console;
  bool m_are_wanted;
  std::set<std::size_t> m_written; // iterations; a strategy can repeat them
};

struct Frame_file
{
  std::size_t iteration;
  std::string file;
};

// Returns the frames of a run in a folder, in order, for a film. \throws Usage_error if there are
// none, or the folder cannot be read
std::vector<Frame_file> frames_in(const std::string& folder);

} // namespace vfc

#endif // VFC_FRAMES_H
