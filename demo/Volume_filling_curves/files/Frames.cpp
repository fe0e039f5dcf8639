// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "files/Frames.h"

#include <CGAL/Volume_filling_curves/without_tails.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

namespace vfc {
namespace {

namespace fs = std::filesystem;

constexpr char prefix[] = "frame_";
constexpr char frame_extension[] = ".obj";

} // namespace

bool Frames::is_frame(const fs::path& file)
{
  const std::string number = file.stem().string();
  const std::size_t start = sizeof prefix - 1;
  return file.extension() == frame_extension && number.compare(0, start, prefix) == 0 &&
         number.find_first_not_of("0123456789", start) == std::string::npos;
}

void Frames::add(std::size_t iteration, const Curve& curve)
{
  if(m_folder.empty() || iteration % m_every != 0) return;
  if(!m_is_prepared) prepare_folder();
  m_is_prepared = true;
  constexpr std::size_t digits = 6;
  std::string number = std::to_string(iteration);
  number.insert(0, digits - (std::min)(digits, number.size()), '0');
  write_curve((fs::path(m_folder) / (prefix + number + frame_extension)).string(),
              CGAL::Volume_filling_curves::without_tails(curve));
}

void Frames::prepare_folder() const
{
  std::error_code error;
  fs::create_directory(m_folder, error);
  std::vector<fs::path> old;
  for(const auto& entry : fs::directory_iterator(m_folder, error))
    if(is_frame(entry.path())) old.push_back(entry.path());
  for(const fs::path& file : old) fs::remove(file, error);
}

} // namespace vfc
