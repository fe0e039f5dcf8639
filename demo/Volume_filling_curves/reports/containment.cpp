// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "reports/containment.h"

#include "reports/Report.h"

#include <algorithm>
#include <utility>

namespace vfc {
namespace {

constexpr std::size_t max_listed_defects = 1000;

// Adds the first defects, and how many there are.
template <typename Nodes>
void add(Defects& defects,
         const std::string& kind,
         const std::string& message,
         const std::string& file,
         const std::vector<std::size_t>& indices,
         const Nodes& nodes,
         const Curve& curve)
{
  for(std::size_t k = 0; k < (std::min)(max_listed_defects, indices.size()); ++k) {
    std::vector<std::size_t> numbers = nodes(indices[k]);
    const std::size_t component = curve.component(numbers[0]) + 1;
    for(std::size_t& v : numbers) v = curve.origin(v) + 1;
    defects.emplace_back(kind, file, numbers, component, message);
  }
  if(indices.size() > max_listed_defects)
    defects.emplace_back(kind, file, std::vector<std::size_t>(), 0,
                         std::to_string(indices.size()) + " of this kind in total, the first " +
                             std::to_string(max_listed_defects) + " are listed");
}

} // namespace

void report_containment(Report& report, const Containment& found)
{
  report["outside_nodes"] = found.outside_nodes.size();
  report["outside_segments"] = found.outside_edges.size();
}

Defects to_defects(const Containment& found, const Curve& curve, const std::string& file)
{
  using Nodes = std::vector<std::size_t>;
  Defects defects;
  add(
      defects, "outside node", "a node is not strictly inside of the mesh", file,
      found.outside_nodes, [](std::size_t v) { return Nodes{v}; }, curve);
  add(
      defects, "outside segment", "an edge is not strictly inside of the mesh", file,
      found.outside_edges,
      [&](std::size_t e) {
        return Nodes{curve.source(e), curve.target(e)};
      },
      curve);
  return defects;
}

} // namespace vfc
