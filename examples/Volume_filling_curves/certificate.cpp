// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Untangles a curve, writes the certificate of that to a file, and verifies what was written. Then
// tampers with it.

#include <CGAL/Volume_filling_curves/untangle.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace VFC = CGAL::Volume_filling_curves;

using Curve = VFC::Curve_network_3<>;
using Point_3 = Curve::Point_3;

// The trefoil as a torus knot.
Curve make_trefoil(int n)
{
  const double pi = 3.14159265358979323846;
  std::vector<std::vector<Point_3>> polylines(1);
  for(int i = 0; i < n; ++i) {
    const double t = 2 * pi * i / n, radius = 2 + std::cos(3 * t);
    polylines[0].emplace_back(radius * std::cos(2 * t), radius * std::sin(2 * t), std::sin(3 * t));
  }
  polylines[0].push_back(polylines[0].front());
  Curve curve;
  std::vector<VFC::Curve_defect> defects;
  VFC::polylines_to_curve_network(polylines, curve, defects);
  return curve;
}

bool verify(const std::string& bytes, const Curve& start, const Curve& end)
{
  const VFC::Isotopy_certificate certificate(bytes);
  const VFC::Certificate_verdict verdict = VFC::verify_certificate(certificate, start, end);
  if(verdict.is_valid) std::cout << "valid, " << verdict.number_of_operations << " operations\n";
  if(verdict.operation > 0) std::cout << "operation " << verdict.operation << ", ";
  if(!verdict.is_valid) std::cout << verdict.message << '\n';
  return verdict.is_valid;
}

int main()
{
  const Curve start = make_trefoil(100);
  Curve end = start;
  VFC::Isotopy_certificate certificate;
  VFC::untangle(end, VFC::parameters::certificate(std::ref(certificate)).keep_length(true));
  std::ofstream("trefoil.cert", std::ios::binary) << certificate.bytes();

  std::ifstream file("trefoil.cert", std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  bool is_ok = verify(bytes, start, end);

  std::cout << certificate.text().substr(0, 300) << "...\n";

  bytes[bytes.size() / 2] ^= 4; // somewhere in the middle, one bit
  is_ok &= !verify(bytes, start, end);
  is_ok &= !verify(certificate.bytes(), end, start);
  return is_ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
