// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "files/Frames.h"

#include <CGAL/Volume_filling_curves/IO/curve_frames.h>
#include <CGAL/Volume_filling_curves/without_tails.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace vfc {
namespace {

namespace fs = std::filesystem;

constexpr char frame_prefix[] = "frame_";
constexpr char list_of_frames[] = "frames.pvd";

} // namespace

bool Frames::is_frame(const fs::path& file)
{
  const std::string number = file.stem().string();
  const std::size_t start = sizeof frame_prefix - 1;
  const bool is_curve = file.extension() == ".obj" || file.extension() == ".vtp";
  return file.filename() == list_of_frames ||
         (is_curve && number.compare(0, start, frame_prefix) == 0 &&
          number.find_first_not_of("0123456789", start) == std::string::npos);
}

void Frames::add(std::size_t iteration, const Curve& curve)
{
  if(m_options.frames.empty() || iteration % m_options.every != 0) return;
  if(m_written.empty()) prepare_folder();
  write_curve((fs::path(m_options.frames) / name(iteration)).string(),
              CGAL::Volume_filling_curves::without_tails(curve));
  m_written.insert(iteration);
}

std::string Frames::name(std::size_t iteration) const
{
  constexpr std::size_t digits = 6;
  std::string number = std::to_string(iteration);
  number.insert(0, digits - (std::min)(digits, number.size()), '0');
  return frame_prefix + number + '.' + m_options.frame_format;
}

void Frames::finish() const
{
  if(m_written.empty() || m_options.frame_format != "vtp") return;
  std::vector<CGAL::Volume_filling_curves::Curve_frame> frames;
  for(const std::size_t iteration : m_written)
    frames.push_back({static_cast<double>(iteration), name(iteration)});
  const std::string file = (fs::path(m_options.frames) / list_of_frames).string();
  std::error_code error;
  if(!CGAL::IO::write_curve_frames(file, frames, error))
    throw Usage_error(file + ": cannot be written: " + error.message());
}

void Frames::prepare_folder() const
{
  std::error_code error;
  fs::create_directory(m_options.frames, error);
  std::vector<fs::path> old;
  for(const auto& entry : fs::directory_iterator(m_options.frames, error))
    if(is_frame(entry.path())) old.push_back(entry.path());
  for(const fs::path& file : old) fs::remove(file, error);
}

} // namespace vfc
