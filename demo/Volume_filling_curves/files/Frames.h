// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_FRAMES_H
#define VFC_FRAMES_H

#include "files/curve_files.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>

namespace vfc {

// The pictures of a film: the curve of every K-th iteration, frame_000000.obj and so on.
class Frames
{
public:
  // Writes nothing if there is no folder. The frames of an earlier run are removed when the first
  // new one is written.
  Frames(std::string folder, std::size_t every) : m_folder(std::move(folder)), m_every(every) {}

  void add(std::size_t iteration, const Curve& curve);

  // returns whether a file of this name is taken for a frame of an earlier run
  static bool is_frame(const std::filesystem::path& file);

private:
  void prepare_folder() const;

  std::string m_folder;
  std::size_t m_every;
  bool m_is_prepared = false;
};

} // namespace vfc

#endif // VFC_FRAMES_H
