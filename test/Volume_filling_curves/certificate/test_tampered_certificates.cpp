// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/certificate_test_support.h"

#include <CGAL/Volume_filling_curves/generators.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace test_tampered_certificates {

using namespace certificate_test;
using CGAL::Volume_filling_curves::make_closed_braid;
using CGAL::Volume_filling_curves::parse_braid_word;
using Point = Network::Point_3;

// A trefoil that is tangled and refined.
Motion tangled_trefoil()
{
  Motion motion;
  motion.start = scaled(make_closed_braid(parse_braid_word("1 1 1"), 36, 0, 1), -2);
  motion.end = motion.start;
  Guard guard(motion.end);
  guard.start_recording();
  internal::Random_tangler<Network::Traits> tangler(guard, 1);
  tangler.tangle(200, 0.5);
  tangler.refine(60);
  tangler.tangle(200, 0.3);
  motion.certificate = guard.certificate();
  return motion;
}

TEST(Tampered_certificate, refuses_a_thousand_tamperings)
{
  const Motion motion = tangled_trefoil();
  const std::string bytes = motion.certificate.bytes();
  Random random(5);
  for(int k = 0; k < 1000; ++k) {
    std::string tampered = bytes;
    const std::size_t i = below(bytes.size(), random), j = below(bytes.size(), random);
    switch(k % 5) {
    case 0:
      tampered[i] = static_cast<char>(tampered[i] ^ (1 << below(8, random)));
      break;
    case 1:
      tampered.resize(i);
      break;
    case 2:
      tampered.erase(i, 1 + below(30, random));
      break;
    case 3:
      tampered.insert(i, bytes.substr(j, 1 + below(30, random)));
      break;
    default:
      std::swap(tampered[i], tampered[j]);
    }
    if(tampered == bytes) continue;
    const Certificate_verdict verdict =
        verify_certificate(Isotopy_certificate(tampered), motion.start, motion.end);
    EXPECT_FALSE(verdict.is_valid) << "tampering " << k;
    EXPECT_FALSE(verdict.message.empty());
  }
}

TEST(Tampered_certificate, refuses_operations_that_were_dropped_swapped_or_altered)
{
  const Motion motion = tangled_trefoil();
  const Pieces original = take_apart(motion.certificate);
  const std::size_t n = original.operations.size();
  Random random(6);
  int refused_by_geometry = 0;
  for(int k = 0; k < 300; ++k) {
    Pieces pieces = original;
    const std::size_t i = below(n, random), j = below(n, random);
    if(k % 3 == 0) {
      pieces.operations.erase(pieces.operations.begin() + static_cast<std::ptrdiff_t>(i));
    } else if(k % 3 == 1) {
      std::swap(pieces.operations[i], pieces.operations[j]);
    } else {
      double& x = pieces.operations[i].position[below(3, random)];
      x = -x - 0.5;
    }
    // without knowing the hash: what is taken over from the original no longer fits
    std::string bytes = put_together(pieces).bytes();
    bytes.replace(bytes.size() - 32, 32, motion.certificate.bytes(),
                  motion.certificate.bytes().size() - 32, 32);
    if(bytes == motion.certificate.bytes()) continue;
    EXPECT_FALSE(verify_certificate(Isotopy_certificate(bytes), motion.start, motion.end).is_valid);
    // with hashes that fit: right only if the guard thinks so, and it leads to the same end
    const Certificate_verdict verdict =
        verify_certificate(put_together(pieces), motion.start, motion.end);
    Guard_replay guard(motion.start);
    const bool is_right =
        guard(pieces.operations) == pieces.operations.size() &&
        internal::Canonical_curve(guard.curve()).digest() == original.trailer.curve;
    EXPECT_EQ(verdict.is_valid, is_right) << verdict.message;
    if(verdict.operation > 0) ++refused_by_geometry;
  }
  EXPECT_GT(refused_by_geometry, 30);
}

// A triangle beside a rod.
Network triangle_and_rod()
{
  return {{Point(1, -1, 0), Point(1, 1, 0), Point(3, 0, 0), Point(0, 0, -2), Point(0, 0, 2)},
          {{0, 1}, {1, 2}, {2, 0}, {3, 4}}};
}

// An edge of the triangle is bent over the end of the rod, to behind it.
Motion edge_over_the_rod()
{
  Motion motion;
  motion.start = motion.end = triangle_and_rod();
  Guard guard(motion.end);
  guard.start_recording();
  EXPECT_TRUE(guard.insert_node(0, Point(-1, 0, 5)));
  EXPECT_TRUE(guard.move_node(5, Point(-1, 0, 0)));
  motion.certificate = guard.certificate();
  return motion;
}

TEST(Tampered_certificate, says_which_operation_is_wrong_and_why)
{
  const Motion motion = edge_over_the_rod();
  EXPECT_TRUE(motion.verdict().is_valid);
  Pieces pieces = take_apart(motion.certificate);
  pieces.operations[0].position = pieces.operations[1].position; // straight through the rod
  pieces.operations.pop_back();
  Certificate_verdict verdict = verify_certificate(put_together(pieces), motion.start, motion.end);
  EXPECT_EQ(verdict.operation, 1u);
  EXPECT_EQ(verdict.message, "inserting a node between 2 and 3: edge (0, 1) is in the way");

  pieces = take_apart(motion.certificate);
  pieces.operations[1].node = 7;
  verdict = verify_certificate(put_together(pieces), motion.start, motion.end);
  EXPECT_EQ(verdict.operation, 2u);
  EXPECT_EQ(verdict.message, "moving node 7: there is no node 7");

  std::string bytes = motion.certificate.bytes();
  bytes.resize(bytes.size() - 100);
  verdict = verify_certificate(Isotopy_certificate(bytes), motion.start, motion.end);
  EXPECT_EQ(verdict.operation, 2u);
  EXPECT_EQ(verdict.message, "the record ends too early");
}

TEST(Tampered_certificate, refuses_other_curves)
{
  const Motion motion = edge_over_the_rod();
  const Network other({Point(1, -1, 0), Point(1, 1, 0), Point(3, 0, 0), Point(0, 0, -2),
                       Point(0, 0, std::nextafter(2., 3.))},
                      {{0, 1}, {1, 2}, {2, 0}, {3, 4}});
  EXPECT_EQ(verify_certificate(motion.certificate, other, motion.end).message,
            "start: the certificate starts from another curve");
  EXPECT_EQ(verify_certificate(motion.certificate, motion.start, motion.start).message,
            "end: the certificate leads to another curve");
  EXPECT_EQ(verify_certificate(motion.certificate, motion.end, motion.start).message,
            "start: the certificate starts from another curve");
  EXPECT_FALSE(verify_certificate(motion.certificate, Network(), Network()).is_valid);
}

TEST(Tampered_certificate, refuses_what_is_no_certificate_of_this_version)
{
  const Motion motion = edge_over_the_rod();
  const auto message = [&](const std::string& bytes) {
    return verify_certificate(Isotopy_certificate(bytes), motion.start, motion.end).message;
  };
  std::string bytes = motion.certificate.bytes();
  EXPECT_EQ(message(""), "this is not a certificate");
  EXPECT_EQ(message("v 0 0 0"), "this is not a certificate");
  EXPECT_EQ(message(bytes + '\0'), "bytes follow the end of the record");
  bytes[8] = 1; // that of release 0.1.0
  const char refusal[] = "version 1 of the format is not supported, only version 2";
  EXPECT_EQ(message(bytes), refusal);
  EXPECT_EQ(message(with_fitting_hash(bytes).bytes()), refusal);
}

TEST(Tampered_certificate, refuses_every_flip_of_a_bit)
{
  const Motion motion = edge_over_the_rod();
  std::string bytes = motion.certificate.bytes();
  for(std::size_t i = 0; i < 8 * bytes.size(); ++i) {
    const char before = bytes[i / 8];
    bytes[i / 8] = static_cast<char>(before ^ (1 << i % 8));
    EXPECT_FALSE(verify_certificate(Isotopy_certificate(bytes), motion.start, motion.end).is_valid);
    bytes[i / 8] = before;
  }
}

} // namespace test_tampered_certificates
