// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "files/Frames.h"

#include "files/Output_files.h"
#include "options/numbers.h"
#include "session/Console.h"
#include "session/errors.h"

#include <CGAL/Volume_filling_curves/untangle.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace vfc {
namespace {

namespace fs = std::filesystem;

constexpr char frame_prefix[] = "frame_";
constexpr std::size_t start_of_number = sizeof frame_prefix - 1;
constexpr char list_of_frames[] = "frames.pvd";

} // namespace

bool Frames::is_frame(const fs::path& file)
{
  const std::string number = file.stem().string();
  const bool is_curve = file.extension() == ".obj" || file.extension() == ".vtp";
  return file.filename() == list_of_frames ||
         (is_curve && number.compare(0, start_of_number, frame_prefix) == 0 &&
          number.find_first_not_of("0123456789", start_of_number) == std::string::npos);
}

void Frames::add(std::size_t iteration, const Curve& curve)
{
  if(m_are_wanted && iteration % m_options.every == 0)
    warn_of_failure([&] { write(iteration, curve); });
}

template <typename Write>
void Frames::warn_of_failure(const Write& write)
{
  try {
    write();
  } catch(const Usage_error& error) {
    m_are_wanted = false;
    m_console.warn(std::string("--frames: ") + error.what() + "; no more frames are written");
  }
}

void Frames::write(std::size_t iteration, const Curve& curve)
{
  if(m_written.empty()) prepare_folder();
  write_curve((fs::path(m_options.frames) / name(iteration)).string(),
              CGAL::Volume_filling_curves::without_closing_rays(curve));
  m_written.insert(iteration);
}

std::string Frames::name(std::size_t iteration) const
{
  constexpr std::size_t digits = 6;
  std::string number = std::to_string(iteration);
  number.insert(0, digits - (std::min)(digits, number.size()), '0');
  return frame_prefix + number + '.' + m_options.frame_format;
}

void Frames::finish(std::size_t iteration, const Curve& curve)
{
  if(!m_are_wanted) return;
  warn_of_failure([&] {
    write(m_written.empty() ? iteration : (std::max)(iteration, *m_written.rbegin()), curve);
    if(m_options.frame_format == "vtp") write_list();
  });
}

// Writes a ParaView collection, which ParaView plays as a film.
void Frames::write_list() const
{
  std::string list = "<?xml version=\"1.0\"?>\n"
                     "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
                     "<Collection>\n";
  for(const std::size_t iteration : m_written)
    list += "<DataSet timestep=\"" + std::to_string(iteration) + "\" part=\"0\" file=\"" +
            name(iteration) + "\"/>\n";
  list += "</Collection>\n</VTKFile>\n";
  const std::string file = (fs::path(m_options.frames) / list_of_frames).string();
  Output_files::write(file, list);
}

void Frames::prepare_folder() const
{
  std::error_code error;
  fs::create_directory(m_options.frames, error);
  std::vector<fs::path> old;
  for(const auto& entry : fs::directory_iterator(m_options.frames, error))
    if(is_frame(entry.path()) && !Output_files::is_to_be_new(entry.path().string()))
      old.push_back(entry.path());
  for(const fs::path& file : old) fs::remove(file, error);
}

std::vector<Frame_file> frames_in(const std::string& folder)
{
  std::error_code error;
  std::vector<Frame_file> frames;
  fs::directory_iterator entry(folder, error);
  for(; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const fs::path file = entry->path();
    if(!Frames::is_frame(file)) continue;
    unsigned long long iteration = 0;
    if(parse(file.stem().string().substr(start_of_number), iteration))
      frames.push_back({static_cast<std::size_t>(iteration), file.string()});
  }
  if(error) throw Usage_error("--film: " + folder + ": cannot be read: " + error.message());
  if(frames.empty())
    throw Usage_error("--film: " + folder + ": holds no frames; --frames of untangle and fill " +
                      "writes them");
  std::sort(frames.begin(), frames.end(),
            [](const Frame_file& a, const Frame_file& b) { return a.iteration < b.iteration; });
  return frames;
}

} // namespace vfc
