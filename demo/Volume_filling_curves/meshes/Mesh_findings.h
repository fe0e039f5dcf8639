// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_MESH_FINDINGS_H
#define VFC_MESH_FINDINGS_H

#include "reports/Defect.h"

#include <CGAL/Volume_filling_curves/internal/domain/mesh_faults.h>

#include <cstddef>
#include <map>
#include <string>

namespace vfc {

// Defects of a mesh file: errors, which make the mesh unusable, and warnings about repairs. Of each
// kind the first 1000 are listed, and the others counted, up to a million.
class Mesh_findings
{
public:
  explicit Mesh_findings(const std::string& file) : m_file(file) {}

  using Fault = CGAL::Volume_filling_curves::internal::Mesh_fault;

  void add_error(const std::string& kind,
                 const std::string& message,
                 const Mesh_location& location = {});
  void add_error(const Fault& fault, const Mesh_location& location = {});
  void add_warning(const std::string& kind,
                   const std::string& message,
                   const Mesh_location& location = {});

  const std::string& file() const { return m_file; }

  bool has_error() const { return m_has_error; }

  // Returns whether there are errors, and repair_mesh() can mend all of their kinds.
  bool is_mendable() const;

  // Returns the defects, and the total of every kind that is not listed completely.
  Defects list() const;

  // Returns one defect of every kind: the first, with the number of others and, for an error, a
  // remedy.
  Defects summary() const;

  static constexpr std::size_t max_counted = 1000000;

private:
  void add(const Defect& defect);

  struct Kind
  {
    std::size_t number = 0;
    std::size_t first = 0; // of the defects
    bool is_error = false;
  };

  static std::string to_text(std::size_t number);

  std::string m_file;
  Defects m_defects;
  std::map<std::string, Kind> m_kinds;
  bool m_has_error = false;
};

} // namespace vfc

#endif // VFC_MESH_FINDINGS_H
