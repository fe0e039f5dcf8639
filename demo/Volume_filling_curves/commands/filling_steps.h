// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The steps of a filling that meshes, sectors and polygons have in common.

#ifndef VFC_FILLING_STEPS_H
#define VFC_FILLING_STEPS_H

#include "files/checkpoints.h"
#include "files/curve_files.h"
#include "files/polygon_files.h"
#include "formats/writers.h"
#include "meshes/read_mesh_soup.h"
#include "options/Fill_options.h"
#include "options/pins.h"
#include "options/ports.h"
#include "options/vertex_fields.h"
#include "reports/containment.h"
#include "reports/fill_report.h"
#include "reports/untangle_report.h"
#include "session/Flow_observer.h"
#include "session/No_result.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

namespace vfc {
namespace filling {

namespace curves = CGAL::Volume_filling_curves;

// Planar curves can be written at true scale.
inline bool is_svg(const Fill_options& options)
{
  return is_polygon_file(options.mesh) && lower_case_extension(options.output) == ".svg";
}

// The curve to start from, empty for circles.
template <typename Domain>
Curve start(Session& session, const Fill_options& options, const Domain& domain)
{
  if(options.start.empty()) return Curve();
  Curve curve = read_curve(session, options.start, options.curve.reading);
  session.report()["input"] = options.mesh;
  Defects outside = to_defects(containment(curve, domain), curve, options.start);
  if(!outside.empty()) throw Input_error(std::move(outside), "strictly inside of " + options.mesh);
  pin_nodes(curve, options.curve);
  return curve;
}

// \throws No_result if the run ends before there is a curve
template <typename Domain>
Filling_result fill(Session& session,
                    Curve& curve,
                    const Domain& domain,
                    const Thickness& field,
                    const Direction_field& directions,
                    const Fill_options& options,
                    const curves::Run_state& state,
                    curves::Isotopy_certificate& certificate)
{
  Flow_observer observer(session, options.parameters, 0, Frames(options.film, session.console()));
  curves::Filling_parameters<> parameters = options.parameters;
  // the rest after reading and mending
  parameters.time_limit = (std::max)(0., parameters.time_limit - session.seconds());
  if(!options.ports.empty()) parameters.ports = read_ports(options.ports);
  parameters.thickness_field = field;
  parameters.direction_field = directions;
  if(!options.certificate.empty()) parameters.certificate = &certificate;
  parameters.resume_from = &state;
  parameters.progress = [&](const curves::Run_progress& progress) {
    return observer.on_progress(progress);
  };
  save_states(session, parameters, options.saving);
  Filling_result result = resume(options.saving, [&] {
    return curves::fill<CGAL::Parallel_if_available_tag>(curve, domain, parameters,
                                                         std::ref(observer));
  });
  if(curve.number_of_nodes() == 0)
    throw No_result(exit_status(result.status),
                    options.mesh + ": the run ended before there was a curve");
  observer.finish(result.statistics.iterations, curve);
  return result;
}

// States why the thickness is not the one that was asked for.
inline void note_thickness(const Session& session,
                           const Fill_options& options,
                           const Filling_result& result)
{
  const curves::Filling_parameters<>& asked_for = options.parameters;
  if(!options.thickness_field.empty() || asked_for.length > 0) return;
  const double least = curves::internal::min_thickness_for(asked_for);
  const auto note = [&](const std::string& reason) {
    session.console().note("thickness " + to_text(result.thickness) + ", " + reason);
  };
  if(asked_for.thickness < least && result.thickness <= least)
    note("the least that allows such bends and distances");
  else if(asked_for.thickness == 0 && !(result.default_thickness > 0))
    note("a quarter of the radius of the widest ball inside");
}

inline void write_result(const Fill_options& options, const Curve& curve, double thickness)
{
  if(options.output.empty()) return;
  if(is_svg(options))
    Output_files::write(options.output, to_svg(Curve_paths(curve)));
  else
    write_curve(options.output, curve, thickness);
}

// Writes a curve that fills a domain.
inline void write(Session& session,
                  const Fill_options& options,
                  const Curve& curve,
                  const Filling_result& result)
{
  note_thickness(session, options, result);
  report_stages(session, result.statistics);
  write_result(options, curve, result.thickness);
  write_map(options.film.map, options.output, curve);
  session.end_stage("writing");
}

// Reports a curve that fills a domain, and returns the exit status.
template <typename Domain>
int report(Session& session,
           const Fill_options& options,
           const Curve& curve,
           const Domain& domain,
           const Direction_field& directions,
           const Filling_result& result)
{
  const bool is_out_of_time = session.seconds() >= options.parameters.time_limit;
  if(session.has_report()) report_filling(session.report(), curve, domain, result, is_out_of_time);
  if(directions && !is_out_of_time)
    session.report()["alignment"] = curves::alignment(curve, directions);
  session.end_stage("measuring");
  session.print_summary(summary(session, curve, result));
  return exit_status(result.status);
}

} // namespace filling
} // namespace vfc

#endif // VFC_FILLING_STEPS_H
