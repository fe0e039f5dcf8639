// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Fills domains with curves, one JSON line per run on standard output:
//
//   benchmark_fill [option...] DOMAIN [[option...] DOMAIN...]
//
// A domain is a file with a closed mesh, or `ball` (radius 1), `box` (the unit cube) or `cube` (the
// same as a mesh of 12 triangles).
//
//   --thickness R    in the input's unit (a quarter of the widest ball's radius)
//   --length L       instead of a thickness
//   --wall cover|keep-clear
//   --preview        without rounding
//   --lambda X, --rmax X, --spacing X, --beta X, --directions N, --tau X,
//   --preconditioner medial|h1|l2|quasi-newton    parameters of the flow, as for vfc
//   --iterations N   at most so many (5000)
//   --time-limit S
//   --seed N         of the samples that guide the run (0); coverage has samples of its own
//   --repeat N       runs of every domain (1)
//   --flow-alone     no call of fill(), but a flow with the same parameters from the start to the
//                    end
//     --alpha X        weight of the medial spheres, in units of 1 / r^2 (9.92)
//     --displacement X largest step, in units of r (0.5)
//     --until-length L ends when the curve is that long
//   -o DIR           write each curve to DIR/NAME.obj
//   --reset          forget all options that stand before
//
// Options hold for the domains after them. The seconds are those of fill(), on one thread: reading
// meshes and measuring curves does not count.

#include "Filling_options.h"
#include "Json_line.h"
#include "command_words.h"
#include "run_filling_flow.h"
#include "surroundings.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/IO/curve_network.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/measures/Least_clearance.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/number_type_config.h>

#include <cstddef>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace vfc = CGAL::Volume_filling_curves;
using vfc_benchmark::Curve;
using vfc_benchmark::Filling;
using vfc_benchmark::Filling_options;
using vfc_benchmark::Json_line;
using vfc_benchmark::Point;
using vfc_benchmark::Traits;
using Mesh = CGAL::Surface_mesh<Point>;

constexpr std::size_t number_of_samples = 20000;
constexpr std::uint64_t seed_of_samples = 1; // others than those that guide a run by default

Mesh cube_of_triangles()
{
  Mesh mesh;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0),
                        Point(0, 1, 1), Point(0, 0, 1), Point(1, 0, 1), Point(1, 1, 1), mesh);
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  return mesh;
}

Mesh read_mesh(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh))
    throw std::runtime_error(file + " cannot be used: see vfc check");
  return mesh;
}

void add_run(Json_line& line, const Filling& filling)
{
  const vfc::Curve_flow_statistics& work = filling.statistics;
  Json_line stages;
  stages.add("medial_spheres", work.seconds_medial_spheres)
      .add("direction", work.seconds_direction)
      .add("motion", work.seconds_motion)
      .add("remeshing", work.seconds_remeshing);
  line.add("status", to_string(filling.status))
      .add("iterations", work.iterations)
      .add("seconds_by_stage", stages)
      .add("moves_certified", work.certified_changes)
      .add("moves_rejected", work.refused_changes)
      .add("shortened_steps", work.shortened_steps)
      .add("refused_remeshing", work.refused_remeshing)
      .add("gradient_norm", filling.gradient_norm);
}

Json_line to_json(const vfc::Coverage& coverage)
{
  Json_line line;
  line.add("samples", coverage.samples)
      .add("mean", coverage.mean)
      .add("p50", coverage.p50)
      .add("p95", coverage.p95)
      .add("p99", coverage.p99)
      .add("max", coverage.max)
      .add("fraction_within_r", coverage.fraction_within_r);
  return line;
}

template <typename Regions>
std::vector<Json_line> to_json(const Regions& regions)
{
  std::vector<Json_line> lines;
  for(const auto& region : regions) {
    const std::vector<double> point = {region.point.x(), region.point.y(), region.point.z()};
    lines.push_back(Json_line().add("point", point).add("volume", region.volume));
  }
  return lines;
}

// What the curve is like, measured anew.
template <typename Domain>
void add_measures(Json_line& line, const Curve& curve, const Domain& domain, double thickness)
{
  const vfc::Domain_samples_3<Traits, Domain> samples(domain, number_of_samples, seed_of_samples);
  const std::vector<double> distances = vfc::sample_distances(curve, samples);
  const vfc::Containment outside = vfc::containment(curve, domain);
  const double clearance =
      vfc::internal::Least_clearance<Curve>(curve, CGAL_PI * thickness)() / thickness;
  line.add("thickness", thickness)
      .add("nodes", curve.number_of_nodes())
      .add("length", vfc::length(curve))
      .add("volume", samples.volume())
      .add("outside_nodes", outside.outside_nodes.size())
      .add("outside_segments", outside.outside_edges.size())
      .add("min_clearance_over_r", clearance)
      .add("coverage", to_json(vfc::coverage(samples, distances, thickness)))
      .add("empty_regions", to_json(vfc::empty_regions(curve, samples, distances, thickness)));
}

void write_file(const Filling_options& options, const std::string& domain, const Curve& curve)
{
  if(options.directory.empty()) return;
  std::filesystem::create_directories(options.directory);
  const std::string stem = std::filesystem::path(domain).stem().string();
  const std::string path = (std::filesystem::path(options.directory) / stem).string();
  if(!CGAL::IO::write_curve_network(path + ".obj", curve))
    throw std::runtime_error("cannot write " + path + ".obj");
}

template <typename Domain>
void run(const std::string& word, const Domain& domain, const Filling_options& options)
{
  Curve curve;
  CGAL::Real_timer timer;
  timer.start();
  const double cpu_start = vfc_benchmark::cpu_seconds();
  const Filling filling = options.is_flow_alone
                              ? vfc_benchmark::run_flow_alone(curve, domain, options)
                              : vfc_benchmark::run_fill(curve, domain, options);
  const double cpu = vfc_benchmark::cpu_seconds() - cpu_start, wall = timer.time();
  write_file(options, word, curve);

  Json_line line;
  line.add("domain", std::filesystem::path(word).stem().string());
  vfc_benchmark::add_options(line, options);
  add_run(line, filling);
  line.add("cpu_seconds", cpu).add("wall_seconds", wall);
  line.add("medial_radius_over_r", filling.medial_radius / filling.thickness);
  add_measures(line, curve, domain, filling.thickness);
  vfc_benchmark::add_surroundings(line);
  std::cout << line.str() << std::endl;
}

void run(const std::string& word, const Filling_options& options)
{
  const Point origin(0, 0, 0);
  if(word == "ball") return run(word, vfc::Ball_domain_3<Traits>(origin, 1), options);
  if(word == "box") return run(word, vfc::Box_domain_3<Traits>(origin, Point(1, 1, 1)), options);
  const Mesh mesh = word == "cube" ? cube_of_triangles() : read_mesh(word);
  run(word, vfc::Triangle_mesh_domain_3<>(mesh), options);
}

} // namespace

int main(int argc, char** argv)
{
  Filling_options options;
  return vfc_benchmark::run_words(
      argc, argv,
      [&](const auto& words, std::size_t& k) {
        return vfc_benchmark::read_option(options, words, k);
      },
      [&](const std::string& word) {
        for(std::size_t i = 0; i < options.repeat; ++i) run(word, options);
      });
}
