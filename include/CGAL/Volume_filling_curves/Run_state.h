// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_RUN_STATE_H
#define CGAL_VOLUME_FILLING_CURVES_RUN_STATE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/Sha256.h>
#include <CGAL/Volume_filling_curves/internal/certificate/format.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/version.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {

namespace internal {
class Run_saver;
} // namespace internal

/// \ingroup PkgVolumeFillingCurvesRef
///
/// is thrown of a `Run_state` that no run can resume from, or not the one that is to.
class Run_state_error : public std::invalid_argument
{
public:
  using std::invalid_argument::invalid_argument;
};

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief The class `Run_state` is all that a run of `untangle()` or `fill()` needs to go on later:
 * the run that resumes from it ends with the same bits as if it had never been interrupted.
 *
 * It is a sequence of bytes, to be kept in a file. The page \ref vfc_interrupted_runs describes it.
 * `Run_checkpoint` gives states out, and `Curve_run_parameters::resume_from` takes one.
 */
class Run_state
{
public:
  /// constructs an empty state. A run that resumes from it starts at the beginning.
  Run_state() = default;

  /*!
   * constructs a state from its bytes. Takes linear time, for a checksum.
   *
   * \throws Run_state_error if they are not those of a state, are cut off or damaged, or come from
   * a version of this package with another format
   */
  explicit Run_state(std::string bytes) : m_bytes(std::move(bytes)) { check(); }

  /// returns the bytes, to be written to a file.
  const std::string& bytes() const { return m_bytes; }

  /// returns whether this is the state of no run.
  bool is_empty() const { return m_bytes.empty(); }

private:
  friend class internal::Run_saver;

  static constexpr std::string_view magic = "VFCSTATE";
  static constexpr int format_version = 1;
  static constexpr std::size_t head_size = 12, checksum_size = 32;

  static std::string head()
  {
    std::string bytes(magic);
    internal::append_little_endian(bytes, std::uint64_t(format_version), 4);
    return bytes;
  }

  static std::string checksum(std::string_view bytes)
  {
    const auto digest = internal::sha256(bytes);
    return std::string(digest.begin(), digest.end());
  }

  static Run_state of_body(const std::string& body)
  {
    Run_state state;
    state.m_bytes = head() + body;
    state.m_bytes += checksum(state.m_bytes);
    return state;
  }

  std::string_view body() const
  {
    return std::string_view(m_bytes).substr(head_size, m_bytes.size() - head_size - checksum_size);
  }

  void check() const
  {
    const std::string_view bytes = m_bytes;
    if(bytes.substr(0, magic.size()) != magic)
      throw Run_state_error("it is not the state of a run");
    if(bytes.size() < head_size + checksum_size)
      throw Run_state_error("the state of the run is cut off");
    if(bytes.substr(0, head_size) != head())
      throw Run_state_error("the state of the run has another format than those of "
                            "version " CGAL_VOLUME_FILLING_CURVES_VERSION);
    const std::size_t size = bytes.size() - checksum_size;
    if(bytes.substr(size) != checksum(bytes.substr(0, size)))
      throw Run_state_error("the state of the run is damaged or cut off");
  }

  std::string m_bytes;
};

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief The class `Run_checkpoint` is a moment between two iterations of `untangle()` or `fill()`,
 * in which the state of the run can be taken.
 *
 * The function `Curve_run_parameters::checkpoint` is given one before each iteration. Taking the
 * state changes nothing of the run.
 */
class Run_checkpoint
{
public:
  /// \cond SKIP_IN_MANUAL
  Run_checkpoint(std::function<Run_state()> take_state, bool is_last)
      : m_take_state(std::move(take_state)), m_is_last(is_last)
  {}
  /// \endcond

  /// returns the state of the run. Takes time linear in the size of the curve and of the
  /// certificate so far, if there is one.
  Run_state state() const { return m_take_state(); }

  /// returns whether the run ends here before its goal, at a limit or since the visitor wants it:
  /// then no other checkpoint follows.
  bool is_last() const { return m_is_last; }

private:
  std::function<Run_state()> m_take_state;
  bool m_is_last;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_RUN_STATE_H
