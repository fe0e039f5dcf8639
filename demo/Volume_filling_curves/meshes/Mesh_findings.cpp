// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/Mesh_findings.h"

#include <algorithm>
#include <iterator>

namespace vfc {
namespace {

constexpr std::size_t max_listed = 1000;

// Remedies of repair_mesh() for errors.
struct Remedy
{
  const char *kind, *text;
};

constexpr Remedy remedies[] = {
    {"ambiguous shells", "if it bounds a cavity, such as an obstacle, orient it inward; repair "
                         "takes both for solids and unites them"},
    {"degenerate face", "repair drops such faces"},
    {"duplicate face", "repair drops all but one"},
    {"non-manifold edge", "repair drops small sheets, or wraps the mesh"},
    {"open boundary", "repair closes holes, or wraps the mesh"},
    {"self-intersection", "repair cuts these out, or unites the shells"},
};

const Remedy* remedy_of(const std::string& kind)
{
  const auto* const found = std::find_if(std::begin(remedies), std::end(remedies),
                                         [&](const Remedy& r) { return kind == r.kind; });
  return found == std::end(remedies) ? nullptr : found;
}

} // namespace

void Mesh_findings::add_error(const std::string& kind,
                              const std::string& message,
                              const Mesh_location& location)
{
  m_has_error = true;
  add({kind, true, m_file, location, message});
}

void Mesh_findings::add_error(const Fault& fault, const Mesh_location& location)
{
  add_error(fault.kind, fault.message, location);
}

void Mesh_findings::add_warning(const std::string& kind,
                                const std::string& message,
                                const Mesh_location& location)
{
  add({kind, false, m_file, location, message});
}

void Mesh_findings::add(const Defect& defect)
{
  const auto [it, is_new] = m_kinds.insert({defect.kind, {0, m_defects.size(), defect.is_error}});
  if(++it->second.number <= max_listed) m_defects.push_back(defect);
}

bool Mesh_findings::is_mendable() const
{
  return m_has_error && std::all_of(m_kinds.begin(), m_kinds.end(), [](const auto& kind) {
           return !kind.second.is_error || remedy_of(kind.first) != nullptr;
         });
}

std::string Mesh_findings::to_text(std::size_t number)
{
  return (number < max_counted ? "" : "at least ") + std::to_string(number);
}

Defects Mesh_findings::list() const
{
  Defects result = m_defects;
  for(const auto& [name, kind] : m_kinds)
    if(kind.number > max_listed)
      result.push_back({name, kind.is_error, m_file, Mesh_location(),
                        to_text(kind.number) + " of this kind in total, the first " +
                            std::to_string(max_listed) + " are listed"});
  return result;
}

Defects Mesh_findings::summary() const
{
  Defects result;
  for(std::size_t i = 0; i < m_defects.size(); ++i) {
    const Defect& defect = m_defects[i];
    const Kind& kind = m_kinds.at(defect.kind);
    if(kind.first != i) continue;
    std::string message = defect.message;
    if(kind.number > 1) message += ", the first of " + to_text(kind.number);
    const Remedy* const remedy = remedy_of(defect.kind);
    if(remedy != nullptr) message += std::string("; ") + remedy->text;
    result.push_back({defect.kind,
                      defect.is_error,
                      m_file,
                      {defect.line, defect.nodes, defect.faces, defect.component},
                      message});
  }
  return result;
}

} // namespace vfc
