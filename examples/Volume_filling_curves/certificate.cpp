// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Untangles a curve, writes the certificate of the run to a file, and verifies the file. Then
// shows that altered certificates are rejected.

#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/untangle.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <string>

namespace VFC = CGAL::Volume_filling_curves;

using Curve = VFC::Curve_network_3<>;

//! [verify]
bool verify(const std::string& bytes, const Curve& start, const Curve& end)
{
  const VFC::Isotopy_certificate certificate(bytes);
  const VFC::Certificate_verdict verdict = VFC::verify_certificate(certificate, start, end);
  std::cout << verdict.sentence() << '\n';
  return verdict.is_valid;
}
//! [verify]

int main()
{
  //! [record]
  const Curve start = VFC::make_torus_knot(2, 3, 100);
  Curve end = start;
  VFC::Isotopy_certificate certificate;
  VFC::untangle(end, VFC::parameters::certificate(std::ref(certificate)).keep_length(true));
  //! [record]
  std::ofstream("trefoil.cert", std::ios::binary) << certificate.bytes();

  std::ifstream file("trefoil.cert", std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  bool is_ok = verify(bytes, start, end);

  std::cout << certificate.text().substr(0, 300) << "...\n";

  bytes[bytes.size() / 2] ^= 4; // one bit in the middle
  is_ok &= !verify(bytes, start, end);
  is_ok &= !verify(certificate.bytes(), end, start);
  return is_ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
