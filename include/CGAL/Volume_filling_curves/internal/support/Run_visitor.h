// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_RUN_VISITOR_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_RUN_VISITOR_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/support/check_concepts.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Thickness_fit.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The visitor as a run sees it. Runs thus compile once for all models of CurveFlowVisitor; a
// virtual call costs nothing compared with an iteration. A filling does not search, and untangling
// has no thin domain: each run calls the functions that concern it.
template <typename Flow>
class Run_visitor
{
public:
  virtual void on_start(const Flow& flow) = 0;
  virtual void on_iteration(const Flow& flow) = 0;
  virtual bool go_further(const Flow& flow) = 0;
  virtual void on_thin_domain(const Thickness_fit& fit) = 0;
  virtual bool on_search(const Search_progress& progress) = 0;

protected:
  ~Run_visitor() = default;
};

// Hands each call on to the caller's visitor.
template <typename Flow, typename Visitor>
class Run_visitor_of final : public Run_visitor<Flow>
{
  static_assert(check_visitor<Visitor, Flow>());

public:
  explicit Run_visitor_of(Visitor& visitor) : m_visitor(visitor) {}

  void on_start(const Flow& flow) override { m_visitor.on_start(flow); }
  void on_iteration(const Flow& flow) override { m_visitor.on_iteration(flow); }
  bool go_further(const Flow& flow) override { return m_visitor.go_further(flow); }
  void on_thin_domain(const Thickness_fit& fit) override { m_visitor.on_thin_domain(fit); }

  bool on_search(const Search_progress& progress) override { return m_visitor.on_search(progress); }

private:
  Visitor& m_visitor;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_RUN_VISITOR_H
