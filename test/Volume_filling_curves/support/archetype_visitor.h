// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_ARCHETYPE_VISITOR_H
#define VFC_TEST_ARCHETYPE_VISITOR_H

#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Thickness_fit.h>

#include <string>

namespace archetypes {

// A model of CurveFlowVisitor that can nothing else: neither be copied nor made from nothing. It
// writes down the order of the calls: s for on_start(), g for go_further(), i for on_iteration(),
// r once for each search, and t for on_thin_domain().
class Visitor
{
public:
  explicit Visitor(int) {}
  Visitor(const Visitor&) = delete;
  Visitor& operator=(const Visitor&) = delete;

  template <typename Flow>
  void on_start(const Flow& flow)
  {
    calls += 's';
    is_fresh = is_fresh && flow.statistics().iterations == 0;
  }

  template <typename Flow>
  void on_iteration(const Flow&)
  {
    calls += 'i';
  }

  template <typename Flow>
  bool go_further(const Flow&)
  {
    calls += 'g';
    return true;
  }

  void on_thin_domain(const CGAL::Volume_filling_curves::Thickness_fit&) { calls += 't'; }

  bool on_search(const CGAL::Volume_filling_curves::Search_progress&)
  {
    if(calls.empty() || calls.back() != 'r') calls += 'r';
    return true;
  }

  std::string calls;
  bool is_fresh = true; // whether the statistics began at 0 at each start
};

} // namespace archetypes

#endif // VFC_TEST_ARCHETYPE_VISITOR_H
