// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_ISOTOPY_CERTIFICATE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_ISOTOPY_CERTIFICATE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/text_form.h>

#include <string>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/Isotopy_guard_3.h
 *
 * \brief The class `Isotopy_certificate` is the record of a certified motion: all changes of a
 * curve as elementary moves. Anyone can verify it without trusting the program that wrote it.
 *
 * A certificate is a sequence of bytes, such as the content of a file: the hash of the start curve,
 * all moves with their coordinates, and the hash of the end curve. Page
 * \ref vfc_certificate_format describes it. The text form has the same content, for human readers.
 *
 * `untangle()`, `fill()`, `simplify_curves()` and `Isotopy_guard_3` write certificates, and
 * `verify_certificate()` verifies them.
 */
class Isotopy_certificate
{
public:
  /// constructs an empty certificate, which is valid for no curve.
  Isotopy_certificate() = default;

  /*!
   * constructs a certificate from the content of a file, in binary or text form. The binary form is
   * checked only by `verify_certificate()`.
   *
   * \throws std::invalid_argument if the content is in text form and has an error; the message
   * gives the line
   */
  explicit Isotopy_certificate(std::string content)
      : m_bytes(internal::is_text_form(content) ? internal::from_text_form(content)
                                                : std::move(content))
  {}

  /// returns the binary form, for example to write it to a file.
  const std::string& bytes() const { return m_bytes; }

  /*!
   * returns the text form, about three times as long: one operation per line. Coordinates have 17
   * significant digits.
   *
   * \throws std::invalid_argument if the bytes are not a certificate
   */
  std::string text() const { return internal::to_text_form(m_bytes); }

private:
  template <typename Traits, typename Domain>
  friend class Isotopy_guard_3;

  static Isotopy_certificate of_bytes(std::string bytes)
  {
    Isotopy_certificate certificate;
    certificate.m_bytes = std::move(bytes);
    return certificate;
  }

  std::string m_bytes;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_ISOTOPY_CERTIFICATE_H
