// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_SCALED_RECORD_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_SCALED_RECORD_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/Canonical_curve.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Certificate_reader.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Certificate_writer.h>

#include <string>
#include <string_view>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Record of a motion with all coordinates multiplied by a power of two, which keeps the order of
// the nodes. The caller scales the start and end curves likewise.
template <typename Curve>
std::string scaled_record(std::string_view bytes,
                          double factor,
                          const Curve& start,
                          const Curve& end)
{
  Certificate_reader reader(bytes);
  Certificate_writer writer;
  Certificate_header header = reader.header();
  header.curve = Canonical_curve(start).digest();
  writer.write(header);
  for(auto operation = reader.operation(); operation.kind != Certificate_operation::Kind::END;
      operation = reader.operation()) {
    for(double& x : operation.position) x *= factor;
    writer.write(operation);
  }
  const Certificate_trailer trailer = reader.trailer();
  writer.write_end(trailer.nodes, trailer.edges, Canonical_curve(end).digest());
  writer.write_record_hash(sha256(writer.bytes()));
  return writer.bytes();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_SCALED_RECORD_H
