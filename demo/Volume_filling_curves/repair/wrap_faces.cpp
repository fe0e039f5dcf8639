// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/repair_steps.h"

#include "options/numbers.h"

#include <CGAL/alpha_wrap_3.h>

#include <utility>

namespace vfc {
namespace {

// Asks the watch at each step.
struct Watching_wrap : CGAL::Alpha_wraps_3::internal::Wrapping_default_visitor
{
  explicit Watching_wrap(Work_watch& watch) : m_watch(&watch) {}

  template <typename Wrapper, typename Facet>
  void before_facet_treatment(const Wrapper&, const Facet&)
  {
    m_watch->check();
  }

private:
  Work_watch* m_watch;
};

} // namespace

std::string wrap_faces(double alpha, Mesh& mesh, Work_watch& watch)
{
  const double offset = alpha / 30;
  Mesh wrap;
  const auto watching = CGAL::parameters::visitor(Watching_wrap(watch)); // CGAL 6 reads the first
  CGAL::alpha_wrap_3(mesh, alpha, offset, wrap, watching, watching);
  mesh = std::move(wrap);
  return "wrapped, since nothing milder helped: by a surface at a distance of " + to_text(offset) +
         ", which enters no cavity and no gap narrower than " + to_text(alpha);
}

} // namespace vfc
