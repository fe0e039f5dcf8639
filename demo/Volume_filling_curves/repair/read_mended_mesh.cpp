// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/read_mended_mesh.h"

#include "meshes/examine_mesh.h"
#include "meshes/read_mesh_soup.h"
#include "options/numbers.h"
#include "repair/repair_mesh.h"
#include "session/Progress.h"
#include "session/Session.h"
#include "session/interruption.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace vfc {
namespace {

// CGAL's constructions are not made for products that leave the range of double.
bool has_common_size(const Mesh_soup& soup)
{
  constexpr double least = 1e-20, most = 1e20;
  CGAL::Bbox_3 box;
  for(const auto& p : soup.points) box += p.bbox();
  double largest = 0;
  for(int i = 0; i < 3; ++i)
    largest = (std::max)({largest, std::abs(box.min(i)), std::abs(box.max(i))});
  return largest >= least && largest <= most;
}

void report_mending(Session& session, const std::string& file, const Mending& mending)
{
  Report::Json& report = session.report()["mending"];
  report = {{"steps", mending.steps},
            {"distance_from_file", mending.from_file},
            {"distance_to_mended", mending.to_mended}};
  for(const std::string& step : mending.steps) session.console().note(file + ": repaired: " + step);
  session.console().note(file + ": repaired: the surface is up to " + to_text(mending.from_file) +
                         " from that in the file, which is up to " + to_text(mending.to_mended) +
                         " from it, by estimate");
}

// A mesh, the findings in its file, and their repairs.
struct Mended_mesh
{
  explicit Mended_mesh(const std::string& file) : findings(file) {}

  Mesh_findings findings;
  Mesh_and_defects mesh;
  std::optional<Mending> mending; // none if there was nothing to mend, or nothing can mend it
};

Mended_mesh read_and_mend(const std::string& file, double alpha, Work_watch& watch)
{
  Mended_mesh result(file);
  watch.begin("reading");
  Mesh_soup soup = read_mesh_soup(file, result.findings);
  poll_interruptions(); // not before: the file may be a pipe that nobody writes to
  result.mesh = examine(soup, result.findings, watch);
  if(!result.findings.is_mendable()) return result;
  if(!has_common_size(soup))
    throw Input_error(result.findings.summary(),
                      "a mesh between 1e-20 and 1e20 in size, which can be repaired");
  result.mending = repair_mesh(soup, alpha, result.mesh.mesh, watch);
  watch.begin("checking");
  Mesh_findings after(file);
  result.mesh = examine(soup_of(result.mesh.mesh), after, watch);
  result.mesh.origins.clear();
  result.mesh.number_of_vertices_in_file = soup.points.size();
  result.mesh.unmended = std::make_shared<const Mesh_soup>(std::move(soup));
  if(!result.mesh.is_valid)
    throw Input_error(result.findings.summary(), "a mesh that can be repaired");
  return result;
}

// The part of the time that is over stands for that of the work.
Mended_mesh mend_in_time(const Session& session,
                         const std::string& file,
                         const Mending_options& options)
{
  const double time_left = options.time_limit - session.seconds();
  Progress progress(session.console());
  Work_watch watch(time_left, [&](const std::string& step, double seconds) {
    if(progress.is_due())
      progress.show(seconds / time_left, step + ", " + std::to_string(std::lround(seconds)) + " s");
    return !is_interruption_requested();
  });
  try {
    return read_and_mend(file, options.alpha, watch);
  } catch(const Work_stopped&) {
    throw unfinished(watch, file, options.time_limit);
  }
}

} // namespace

Mesh_and_defects read_mended_mesh(Session& session,
                                  const std::string& file,
                                  const Mending_options& options)
{
  Mended_mesh mended = mend_in_time(session, file, options);
  session.end_stage(mended.mending ? "mending" : "reading");
  if(mended.mending)
    report_mending(session, file, *mended.mending);
  else {
    accept(session, mended.findings);
    session.console().note(file + ": there is nothing to repair");
  }
  return std::move(mended.mesh);
}

No_result unfinished(const Work_watch& watch, const std::string& file, double time_limit)
{
  const std::string reason =
      watch.is_interrupted() ? "interrupted" : "not repaired within " + to_text(time_limit) + " s";
  return No_result(watch.is_interrupted() ? INTERRUPTED : LIMIT_REACHED,
                   file + ": " + reason + ", while " + watch.step() + "; nothing was written");
}

} // namespace vfc
