// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_RUN_STATE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_RUN_STATE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/Sha256.h>

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/untangle.h
///
/// thrown if a `Run_state` is damaged or belongs to a different run.
class Run_state_error : public std::invalid_argument
{
public:
  using std::invalid_argument::invalid_argument;
};

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/untangle.h
 *
 * \brief The class `Run_state` is a snapshot of a run of `untangle()` or `fill()`. A run that
 * resumes from it ends with the same bits as an uninterrupted run.
 *
 * `Run_checkpoint` provides states, and `Curve_run_parameters::resume_from` takes one; the page
 * \ref vfc_interrupted_runs describes their use.
 */
class Run_state
{
public:
  /// constructs an empty state. A run that resumes from it starts at the beginning.
  Run_state() = default;

  /// constructs a state from its bytes. Takes linear time, for a checksum.
  ///
  /// \throws Run_state_error if the bytes are not a state, or are damaged or truncated
  explicit Run_state(std::string bytes) : m_bytes(std::move(bytes))
  {
    const std::string_view all = m_bytes;
    if(all.substr(0, magic.size()) != magic)
      throw Run_state_error("this is not the state of a run");
    if(all.size() < magic.size() + checksum_size || all != sealed(body()).m_bytes)
      throw Run_state_error("the state of the run is damaged or truncated");
  }

  /// returns the bytes, for example to write them to a file.
  const std::string& bytes() const { return m_bytes; }

  /// returns whether the state is empty.
  bool is_empty() const { return m_bytes.empty(); }

  /// \cond SKIP_IN_MANUAL
  static Run_state sealed(std::string_view body)
  {
    Run_state state;
    state.m_bytes.append(magic).append(body);
    const auto digest = internal::sha256(state.m_bytes);
    state.m_bytes.append(digest.begin(), digest.end());
    return state;
  }

  // \pre the state is not empty
  std::string_view body() const
  {
    return std::string_view(m_bytes).substr(magic.size(),
                                            m_bytes.size() - magic.size() - checksum_size);
  }
  /// \endcond

private:
  static constexpr std::string_view magic = "VFCSTATE";
  static constexpr std::size_t checksum_size = 32;

  std::string m_bytes;
};

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/untangle.h
///
/// A point between two iterations of `untangle()` or `fill()` at which the state of the run can be
/// saved. Saving it does not affect the run.
struct Run_checkpoint
{
  /// Returns the state of the run. Takes time linear in the size of the curve and of its
  /// certificate, if one is recorded.
  std::function<Run_state()> state;

  /// Whether the run ends here before its goal, at a limit or on request of the visitor. No other
  /// checkpoint follows then.
  bool is_last;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_RUN_STATE_H
