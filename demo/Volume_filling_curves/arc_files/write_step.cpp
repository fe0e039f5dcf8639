// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// STEP by hand, as few entities are needed: the product that every file has, and its curves as
// circles and lines, which machines can follow, rather than as splines.

#include "arc_files/arc_writers.h"
#include "options/numbers.h"

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <stdexcept>
#include <vector>

namespace vfc {
namespace {

using CGAL::Volume_filling_curves::internal::to_vector;
using Vector_3 = CGAL::Volume_filling_curves::internal::Vector;
using Piece = CGAL::Volume_filling_curves::Arc_spline_piece<Curve::Point_3>;
using Path = CGAL::Volume_filling_curves::Arc_spline_path<Curve::Point_3>;

// Readers take points closer than that, in the unit of the file, for one (OpenCASCADE).
constexpr double length_tolerance = 1e-7;

// A real number has a point, and an exponent a capital E.
std::string real(double x)
{
  std::string mantissa = to_exact_text(x), exponent;
  const std::size_t e = mantissa.find('e');
  if(e != std::string::npos) {
    exponent = 'E' + mantissa.substr(e + 1);
    mantissa.resize(e);
  }
  return mantissa + (mantissa.find('.') == std::string::npos ? "." : "") + exponent;
}

std::string reals(const Vector_3& v)
{
  return '(' + real(v.x()) + ',' + real(v.y()) + ',' + real(v.z()) + ')';
}

class Step_file
{
public:
  explicit Step_file(Length_unit unit) : m_context(context(unit)) {}

  void add(const Path& path, const std::string& name)
  {
    const std::vector<std::string> curves = trimmed_curves(path);
    if(curves.empty())
      throw std::invalid_argument(name + " is shorter than " + to_text(length_tolerance) +
                                  ", which readers of STEP take for a point");
    std::vector<std::string> segments;
    for(std::size_t k = 0; k < curves.size(); ++k) {
      const bool is_last = k + 1 == curves.size() && !path.is_closed;
      segments.push_back(entity(std::string("COMPOSITE_CURVE_SEGMENT(.") +
                                (is_last ? "DISCONTINUOUS" : "CONTINUOUS") + ".,.T.," + curves[k] +
                                ')'));
    }
    m_curves.push_back(entity("COMPOSITE_CURVE('" + name + "'," + list(segments) + ",.F.)"));
  }

  std::string text()
  {
    const std::string set = entity("GEOMETRIC_CURVE_SET(''," + list(m_curves) + ')');
    const std::string shape = entity("GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',(" +
                                     set + ")," + m_context + ')');
    entity("SHAPE_DEFINITION_REPRESENTATION(" + product() + ',' + shape + ')');
    return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
           "FILE_NAME('','',(''),(''),'','vfc','');\n"
           "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n" +
           m_data + "ENDSEC;\nEND-ISO-10303-21;\n";
  }

private:
  // Returns the name of a new entity.
  std::string entity(const std::string& definition)
  {
    std::string name = '#' + std::to_string(++m_number_of_entities);
    m_data += name + '=' + definition + ";\n";
    return name;
  }

  static std::string list(const std::vector<std::string>& names)
  {
    std::string text;
    for(const std::string& name : names) text += (text.empty() ? "(" : ",") + name;
    return text + ')';
  }

  std::string product()
  {
    const std::string application = entity("APPLICATION_CONTEXT('automotive design')");
    entity("APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000," +
           application + ')');
    const std::string context = entity("PRODUCT_CONTEXT(''," + application + ",'mechanical')");
    const std::string product = entity("PRODUCT('curve','curve','',(" + context + "))");
    const std::string formation = entity("PRODUCT_DEFINITION_FORMATION('',''," + product + ')');
    const std::string part =
        entity("PRODUCT_DEFINITION_CONTEXT('part definition'," + application + ",'design')");
    const std::string definition =
        entity("PRODUCT_DEFINITION('design',''," + formation + ',' + part + ')');
    return entity("PRODUCT_DEFINITION_SHAPE('',''," + definition + ')');
  }

  std::string length_unit(Length_unit unit)
  {
    const auto metric = [&](const std::string& prefix) {
      return entity("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(" + prefix + ",.METRE.))");
    };
    if(unit == Length_unit::METER) return metric("$");
    if(unit == Length_unit::CENTIMETER) return metric(".CENTI.");
    const std::string millimeter = metric(".MILLI.");
    if(unit != Length_unit::INCH) return millimeter;
    const std::string dimensions = entity("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)");
    const std::string inch =
        entity("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4)," + millimeter + ')');
    return entity("(CONVERSION_BASED_UNIT('INCH'," + inch + ")LENGTH_UNIT()NAMED_UNIT(" +
                  dimensions + "))");
  }

  std::string context(Length_unit unit)
  {
    const std::string length = length_unit(unit);
    const std::string angle = entity("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    const std::string solid = entity("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    const std::string uncertainty =
        entity("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(" + real(length_tolerance) + ")," +
               length + ",'distance_accuracy_value','')");
    return entity("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((" +
                  uncertainty + "))GLOBAL_UNIT_ASSIGNED_CONTEXT((" + length + ',' + angle + ',' +
                  solid + "))REPRESENTATION_CONTEXT('',''))");
  }

  // Readers drop what is shorter than the tolerance, so the next piece takes its place, from where
  // the last one ended. So no gap is wider than the tolerance.
  std::vector<std::string> trimmed_curves(const Path& path)
  {
    std::vector<std::string> curves;
    Vector_3 last = to_vector(path.pieces.front().start);
    for(const Piece& piece : path.pieces) {
      const Vector_3 end = to_vector(piece.end);
      if((end - last).norm() <= length_tolerance) continue;
      curves.push_back(is_round(piece) ? arc(piece) : line(last, end));
      last = end;
    }
    return curves;
  }

  // whether an arc rises above its chord by more than the tolerance
  static bool is_round(const Piece& piece)
  {
    const Vector_3 middle = (to_vector(piece.start) + to_vector(piece.end)) / 2;
    return piece.is_arc() && (to_vector(piece.middle) - middle).norm() > length_tolerance;
  }

  std::string point(const Vector_3& p) { return entity("CARTESIAN_POINT(''," + reals(p) + ')'); }
  std::string direction(const Vector_3& u) { return entity("DIRECTION(''," + reals(u) + ')'); }

  // the part of a line from its point on, or of a circle from its first axis on
  std::string trimmed(const std::string& curve, double parameter)
  {
    return entity("TRIMMED_CURVE(''," + curve + ",(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(" +
                  real(parameter) + ")),.T.,.PARAMETER.)");
  }

  std::string line(const Vector_3& from, const Vector_3& to)
  {
    const double length = (to - from).norm();
    const std::string start = point(from), along = direction((to - from) / length);
    const std::string vector = entity("VECTOR(''," + along + ",1.)");
    return trimmed(entity("LINE(''," + start + ',' + vector + ')'), length);
  }

  std::string arc(const Piece& piece)
  {
    const Vector_3 start = to_vector(piece.start), corner = to_vector(piece.corner);
    const Vector_3 along = (corner - start).normalized();
    const Vector_3 axis = along.cross(to_vector(piece.end) - corner).normalized();
    const Vector_3 outward = along.cross(axis).normalized();
    const std::string center = point(start - piece.radius * outward);
    const std::string z = direction(axis), x = direction(outward);
    const std::string frame = entity("AXIS2_PLACEMENT_3D(''," + center + ',' + z + ',' + x + ')');
    return trimmed(entity("CIRCLE(''," + frame + ',' + real(piece.radius) + ')'),
                   piece.length / piece.radius);
  }

  std::string m_data;
  std::size_t m_number_of_entities = 0;
  std::string m_context;
  std::vector<std::string> m_curves;
};

} // namespace

std::string to_step(const Arcs& arcs, Length_unit unit)
{
  if(arcs.paths.empty()) throw std::invalid_argument("the curve is empty");
  Step_file file(unit);
  std::size_t number = 0;
  for(const Path& path : arcs.paths) file.add(path, "component " + std::to_string(++number));
  return file.text();
}

} // namespace vfc
