// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "reports/chain_report.h"

#include "options/numbers.h"
#include "reports/report_rows.h"

namespace vfc {

namespace curves = CGAL::Volume_filling_curves;

namespace {

Report::Json name_or_null(const std::string& name)
{
  return name.empty() ? Report::Json() : Report::Json(name);
}

std::string text_of(const Report::Json& name)
{
  return name.is_null() ? "unnamed" : std::string(name);
}

Report::Json report_of(const curves::Knot_share& knot)
{
  return {{"name", name_or_null(knot.name)},
          {"is_proved", knot.is_proved},
          {"count", knot.count},
          {"share", knot.share},
          {"standard_error", knot.standard_error}};
}

Report::Json report_of(const curves::Closure_knot& knot)
{
  return {{"name", name_or_null(knot.name)}, {"is_proved", knot.is_proved}};
}

Report::Json report_of(const curves::Chain_section& section)
{
  return {{"first", section.first + 1},
          {"last", section.last + 1},
          {"name", name_or_null(section.name)},
          {"share", section.share}};
}

Report::Json reports_of(const std::vector<curves::Chain_section>& sections)
{
  Report::Json all = Report::Json::array();
  for(const curves::Chain_section& section : sections) all.push_back(report_of(section));
  return all;
}

std::string section_row(const std::string& key, const Report::Json& section)
{
  return row(key, text_of(section["name"]) + ", nodes " + section["first"].dump() + " to " +
                      section["last"].dump() + ", share " + to_text(section["share"]));
}

} // namespace

Report::Json chain_report(const curves::Chain_identity& identity, std::size_t nodes)
{
  Report::Json report;
  report["nodes"] = nodes;
  report["name"] = name_or_null(identity.name);
  std::size_t closures = 0;
  for(const curves::Knot_share& knot : identity.knots) closures += knot.count;
  report["closures"] = closures;
  for(const curves::Knot_share& knot : identity.knots) report["knots"].push_back(report_of(knot));
  report["direct"] = report_of(identity.direct);
  report["least_interfering"] = report_of(identity.least_interfering);
  report["core"] = identity.core.empty() ? Report::Json() : report_of(identity.core.front());
  report["slipknots"] =
      identity.fingerprint.empty() ? Report::Json() : reports_of(identity.slipknots);
  return report;
}

std::string chain_text(const Report::Json& chain)
{
  return text_of(chain["name"]) + " in " + chain["knots"][0]["count"].dump() + " of " +
         counted(std::size_t(chain["closures"]), "closure");
}

std::string chain_details(const Report::Json& chain)
{
  std::string text;
  for(const Report::Json& knot : chain["knots"])
    text += row("share_of_" + text_of(knot["name"]),
                to_text(knot["share"]) + " +- " + to_text(knot["standard_error"]));
  for(const std::string key : {"direct", "least_interfering"})
    text += row(key, text_of(chain[key]["name"]));
  if(!chain["core"].is_null()) text += section_row("core", chain["core"]);
  for(const Report::Json& slipknot : chain["slipknots"]) text += section_row("slipknot", slipknot);
  return text;
}

std::string fingerprint_csv(const curves::Chain_identity& identity)
{
  std::string text = "first,last,knot,share\n";
  for(const curves::Chain_section& section : identity.fingerprint)
    text += std::to_string(section.first + 1) + ',' + std::to_string(section.last + 1) + ',' +
            section.name + ',' + to_text(section.share) + '\n';
  return text;
}

} // namespace vfc
