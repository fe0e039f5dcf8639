// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_UNKNOT_PROOFS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_UNKNOT_PROOFS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/knots/Link_triviality.h>
#include <CGAL/Volume_filling_curves/internal/knots/unknot_proof.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_result.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Proofs that the components of a moving curve are unknots, and that their link is trivial or not.
// Curves only change by isotopies, hence a proof, once found, remains valid.
template <typename Network>
class Unknot_proofs
{
public:
  // searches for further proofs with the current curves
  void update(const Network& curves)
  {
    m_proofs.resize(curves.number_of_components(), Unknot_proof::NONE);
    for(std::size_t c = 0; c < m_proofs.size(); ++c)
      if(m_proofs[c] == Unknot_proof::NONE) m_proofs[c] = unknot_proof(curves, c);
    if(are_unknots()) update_link(curves);
  }

  // whether the curves are proved to be an unknot or a trivial link
  bool is_proved() const
  {
    return m_link == Link_status::TRIVIAL || (m_proofs.size() == 1 && are_unknots());
  }

  // Stores the proofs, and whether the components are linked, which no run needs before its end.
  void write(const Network& curves, Untangling_result& result)
  {
    update_link(curves);
    result.proofs = m_proofs;
    result.link = m_link;
  }

  // the state of the proofs
  auto contents() { return std::tie(m_proofs, m_link); }

private:
  bool are_unknots() const
  {
    return !m_proofs.empty() &&
           std::find(m_proofs.begin(), m_proofs.end(), Unknot_proof::NONE) == m_proofs.end();
  }

  void update_link(const Network& curves)
  {
    if(m_link == Link_status::UNDECIDED) m_link = Link_triviality<Network>(curves)(m_proofs);
  }

  std::vector<Unknot_proof> m_proofs; // one per component
  Link_status m_link = Link_status::UNDECIDED;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_UNKNOT_PROOFS_H
