// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_RECORDING_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_RECORDING_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Records what happens to a network during the life of this object, if that is wanted.
template <typename Traits>
class Recording
{
public:
  Recording(Curve_network_3<Traits>& curve, bool is_wanted) : m_guard(curve), m_is_wanted(is_wanted)
  {
    if(m_is_wanted) m_guard.start_recording();
  }

  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  ~Recording()
  {
    if(m_is_wanted) m_guard.stop_recording();
  }

  // \pre recording is wanted
  Isotopy_certificate certificate() const { return m_guard.certificate(); }

private:
  Isotopy_guard_3<Traits> m_guard;
  bool m_is_wanted;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_RECORDING_H
