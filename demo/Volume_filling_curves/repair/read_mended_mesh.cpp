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
#include "session/Session.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>

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

void tell(Session& session, const std::string& file, const Mending& mending)
{
  Report::Json& report = session.report()["mending"];
  report = {{"steps", mending.steps},
            {"distance_from_file", mending.from_file},
            {"distance_to_mended", mending.to_mended}};
  for(const std::string& step : mending.steps) session.console().note(file + ": mended: " + step);
  session.console().note(file + ": mended: the surface is up to " + to_text(mending.from_file) +
                         " from that in the file, which is up to " + to_text(mending.to_mended) +
                         " from it, by estimate");
}

} // namespace

Mesh_and_defects read_mended_mesh(Session& session, const std::string& file, double alpha)
{
  Mesh_findings findings(file);
  const Mesh_soup soup = read_mesh_soup(file, findings);
  Mesh_and_defects result = examine(soup, findings);
  if(!findings.is_mendable()) {
    accept(session, findings);
    session.console().note(file + ": there is nothing to mend");
    session.end_stage("reading");
    return result;
  }
  if(!has_common_size(soup))
    throw Input_error(findings.summary(),
                      "a mesh between 1e-20 and 1e20 in size, which can be mended");
  session.end_stage("reading");
  const Mending mending = repair_mesh(soup, alpha, result.mesh);
  Mesh_findings after(file);
  result = examine(soup_of(result.mesh), after);
  result.origins.clear();
  if(!result.is_valid) throw Input_error(findings.summary(), "a mesh that repair can mend");
  tell(session, file, mending);
  session.end_stage("mending");
  return result;
}

} // namespace vfc
