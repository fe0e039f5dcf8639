// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc draw: a picture of a curve, and of a surface around it, or a film of a run.

#include "commands/commands.h"
#include "files/Frames.h"
#include "files/curve_files.h"
#include "files/polygon_files.h"
#include "film/Film.h"
#include "film/film_page.h"
#include "meshes/flat_mesh.h"
#include "options/Command_line.h"
#include "options/option_kinds.h"
#include "options/picture_option_texts.h"
#include "pictures/curve_pictures.h"
#include "session/Exit_status.h"
#include "session/errors.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vfc {
namespace {

struct Draw_options
{
  std::string file, mesh, output;
  Picture_options picture;
  std::string frames; // of a film
  Curve_reading reading;
};

bool has_extension(const std::string& file, const std::string& extension)
{
  return file.size() > extension.size() &&
         file.compare(file.size() - extension.size(), extension.size(), extension) == 0;
}

Mesh read_surface(Session& session, const std::string& file)
{
  if(is_polygon_file(file)) return flat_mesh(read_polygons(session, file).polygons);
  return file.empty() ? Mesh() : read_mesh(session, file).mesh;
}

int finish(Session& session, const std::string& file, const std::string& content)
{
  Output_files::write(file, content);
  session.end_stage("drawing");
  session.report()["status"] = "done";
  session.print_summary("wrote " + file + '\n');
  return GOAL_REACHED;
}

int draw_picture(Session& session, Draw_options options)
{
  if(options.file.empty()) throw Usage_error("CURVE is missing");
  const bool is_svg = has_extension(options.output, ".svg");
  if(!is_svg && !has_extension(options.output, ".png"))
    throw Usage_error("--output: " + options.output + ": pictures are .svg or .png files");
  session.add_input(options.file);
  if(!options.mesh.empty()) session.add_input(options.mesh);
  session.outputs().add("--output", options.output);
  const Curve curve = read_curve(session, options.file, options.reading);
  const Mesh mesh = read_surface(session, options.mesh);
  if(is_polygon_file(options.mesh) && !options.picture.direction)
    options.picture.direction = Vector(0, 0, 1); // the plane from above
  const auto picture = is_svg ? svg_picture : png_picture;
  return finish(session, options.output, picture(curve, mesh, options.picture));
}

// The curves are those of the frames; the only argument is the surface.
int draw_film(Session& session, const Draw_options& options)
{
  if(!options.mesh.empty())
    throw Usage_error("--film: the curves are those of " + options.frames +
                      "; MESH is the only argument");
  if(!has_extension(options.output, ".html"))
    throw Usage_error("--output: " + options.output + ": films are .html files");
  const std::vector<Frame_file> frames = frames_in(options.frames);
  for(const Frame_file& frame : frames) session.add_input(frame.file);
  if(!options.file.empty()) session.add_input(options.file);
  session.outputs().add("--output", options.output);
  const std::string three_js = read_three_js();
  Film film(options.frames, read_surface(session, options.file));
  for(const Frame_file& frame : frames)
    film.add(frame.iteration, read_curve(session, frame.file, options.reading));
  session.report()["input"] = options.frames;
  return finish(session, options.output, film_page(film.to_json(options.picture.tube), three_js));
}

int draw(Session& session, const Draw_options& options)
{
  return options.frames.empty() ? draw_picture(session, options) : draw_film(session, options);
}

// Takes the value of an option if `parse` makes sense of it.
template <typename Target, typename Value>
CLI::Option& add_parsed(CLI::App& command,
                        const std::string& name,
                        Target& target, // a value, or an optional one
                        std::optional<Value> (*parse)(const std::string& text),
                        const std::string& description,
                        const std::string& expected)
{
  const auto check = [parse, expected](const std::string& text) {
    return parse(text) ? std::string() : "'" + text + "' is not " + expected;
  };
  return *command
              .add_option_function<std::string>(
                  name, [&target, parse](const std::string& text) { target = *parse(text); },
                  description)
              ->check(CLI::Validator(check, ""));
}

void add_options_of_pictures(CLI::App& command, Picture_options& picture)
{
  const std::string group = "Options of pictures";
  add_choice(command, "--color", picture.coloring,
             {{"component", Coloring::COMPONENT},
              {"arclength", Coloring::ARCLENGTH},
              {"radius", Coloring::RADIUS},
              {"curvature", Coloring::CURVATURE},
              {"thickness", Coloring::THICKNESS}},
             "quantity shown by the color: component or, with a scale, arclength, radius, "
             "curvature or thickness; see below")
      .group(group);
  add_parsed(command, "--view", picture.direction, parse_direction,
             "viewing direction x,y,z, or azimuth,elevation in degrees, y up; default: where the "
             "curve hides least of itself, with MESH 0.45,0.35,1",
             "a direction x,y,z or azimuth,elevation with an elevation from -90 to 90")
      .type_name("VIEW")
      ->group(group);
  add_parsed(command, "--size", picture.pixels, parse_size,
             "pixels of each side, or width and height as in 1600x900",
             "a whole number N or two of them, WxH, from 100 to 4000")
      .default_str("800")
      ->type_name("N|WxH")
      ->group(group);
  add_parsed(command, "--cut", picture.cut, parse_plane,
             "plane such as x=0.5, or a,b,c,d for a x + b y + c z = d, in the input's unit; "
             "everything on the viewer's side is left out",
             "a plane x=0.5, y=0.5, z=0.5 or a,b,c,d")
      .type_name("PLANE")
      ->group(group);
  add_number(command, "--tube", picture.tube,
             "radius of the tube, for a film the initial one, in the input's unit; default: suits "
             "the picture")
      .type_name("R")
      ->group(group);
  command
      .add_flag("--labels", picture.has_labels,
                "write numbers of nodes, in file order from 1, where space allows")
      ->group(group);
}

void add_options_of_films(CLI::App& command, Draw_options& options)
{
  const std::string group = "Options of films";
  CLI::Option& film = add_file(command, "--film", options.frames,
                               "folder of the frames of a run, as --frames DIR writes them");
  film.type_name("DIR")->group(group);
  for(const char* const name : {"--color", "--view", "--size", "--cut", "--labels"})
    film.excludes(command.get_option(name));
}

} // namespace

void add_draw_command(Command_line& command_line)
{
  const auto options = std::make_shared<Draw_options>();
  CLI::App& command = command_line.add_command(
      "draw", "draw a curve, alone or in a surface, or make a film of a run",
      [options](Session& session) { return draw(session, *options); });
  add_curve(command, options->file).required(false);
  add_mesh(command, options->mesh)
      .description("a surface, drawn translucent around the curve, or polygons (.wkt)");
  add_file(command, "-o,--output", options->output, "the picture, .svg or .png, or the film, .html")
      .required();
  add_reading_flags(command, options->reading);
  add_options_of_pictures(command, options->picture);
  add_options_of_films(command, *options);
  command.footer(
      "  vfc draw CURVE [MESH] -o PICTURE\n"
      "  vfc draw --film DIR [MESH] -o FILM.html\n"
      "\n"
      "Colors, whose numbers are in the input's unit:\n"
      "  arclength   length along the component, from its first node\n"
      "  radius      mean of the node's medial radii: the distance of other\n"
      "              strands, capped at twice the default thickness of untangle\n"
      "  curvature   reciprocal of the bend radius of the node\n"
      "  thickness   radius of the thickest tube that neither kinks at the node nor meets a\n"
      "              strand there, with the same cap\n"
      "The scale covers all values except the lowest and the highest hundredth.\n"
      "\n"
      "A film is one file, which a browser plays without a network. It needs three.js, Debian's\n"
      "libjs-three or npm's three@0.149, when it is written.");
}

} // namespace vfc
