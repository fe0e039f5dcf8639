// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/certificate_test_support.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_certificate {

using namespace certificate_test;
using Point = Network::Point_3;

std::string hex(const std::string& bytes)
{
  std::string text;
  for(const char c : bytes) {
    const auto byte = static_cast<std::uint8_t>(c);
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

Network square()
{
  return {{Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)},
          {{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
}

// All kinds of operations.
Isotopy_certificate small_certificate(Network& curve)
{
  Guard guard(curve);
  guard.start_recording();
  EXPECT_TRUE(guard.move_node(0, Point(-1, -1, 0.5)));
  EXPECT_TRUE(guard.insert_node(0, Point(0, -2, 0)));
  EXPECT_TRUE(guard.remove_node(2));
  guard.collect_garbage();
  return guard.certificate();
}

Isotopy_certificate small_certificate()
{
  Network curve = square();
  return small_certificate(curve);
}

// The numbers come from test_certificate_format.py.
TEST(Certificate, has_the_documented_bytes)
{
  const std::string bytes = small_certificate().bytes();
  EXPECT_EQ(hex(bytes.substr(0, 36)), "5646432d43455254"
                                      "02000000"
                                      "0400000000000000"
                                      "0400000000000000"
                                      "0100000000000000");
  EXPECT_EQ(hex(bytes.substr(68, 25)), "00" // move node 0
                                       "000000000000f0bf000000000000f0bf000000000000e03f");
  EXPECT_EQ(hex(bytes.substr(93, 26)), "0104" // between the nodes 0 and 2
                                       "000000000000000000000000000000c00000000000000000");
  EXPECT_EQ(hex(bytes.substr(119, 1)), "1a"); // remove node 3
  EXPECT_EQ(hex(bytes.substr(120, 25)), "03"
                                        "0300000000000000"
                                        "0400000000000000"
                                        "0400000000000000");
  EXPECT_EQ(bytes.size(), 120u + 25 + 32 + 32);
}

TEST(Certificate, hashes_the_documented_bytes_of_a_curve)
{
  const auto header = take_apart(small_certificate()).header;
  EXPECT_EQ(internal::to_hex(header.curve),
            "819b991646ec9e847bfe2917f3c24e6af10fc3e822a92a8a87c864feb8d5d311");
}

TEST(Certificate, has_a_text_form)
{
  const Isotopy_certificate certificate = small_certificate();
  const std::string text = certificate.text();
  EXPECT_EQ(text.substr(0, 32),
            "VFC-CERT text 2\nstart 4 4 1 " +
                internal::to_hex(take_apart(certificate).header.curve).substr(0, 4));
  EXPECT_NE(text.find("\nmove 0 -1 -1 0.5\ninsert 0 2 0 -2 0\nremove 3\nend 3 4 4 "),
            std::string::npos);
  EXPECT_EQ(Isotopy_certificate(text).bytes(), certificate.bytes());
}

TEST(Certificate, comes_back_from_its_text_form)
{
  Random random(1);
  for(int k = 0; k < 100; ++k) {
    Network curve = to_network(random_curve(4, false, random));
    Guard guard(curve);
    guard.start_recording();
    change_at_random(guard, 40, 4, random);
    const Isotopy_certificate certificate = guard.certificate();
    EXPECT_EQ(Isotopy_certificate(certificate.text()).bytes(), certificate.bytes());
    EXPECT_EQ(put_together(take_apart(certificate)).bytes(), certificate.bytes());
  }
}

TEST(Certificate, names_the_line_of_an_error_in_the_text)
{
  const std::string text = small_certificate().text();
  const auto message_with = [&](const std::string& old_words, const std::string& new_words) {
    std::string changed = text;
    changed.replace(changed.find(old_words), old_words.size(), new_words);
    try {
      Isotopy_certificate certificate(changed);
    } catch(const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(message_with("text 2", "text 1"),
            "line 1: this version of the format is not supported, only version 2");
  EXPECT_EQ(message_with("start 4 4 1", "start 4 4"), "line 2: the line of the start is wrong");
  EXPECT_EQ(message_with("0.5", "0.5.5"), "line 3: a number is wrong");
  EXPECT_EQ(message_with("0.5", "inf"), "line 3: a coordinate is not finite");
  EXPECT_EQ(message_with("move 0 -1", "move -1 -1"), "line 3: a number is wrong");
  EXPECT_EQ(message_with("move 0 -1", "move  0 -1"), "line 3: there is a superfluous space");
  EXPECT_EQ(message_with("insert 0", "insert 9999999999999999999"),
            "line 4: a number is too large");
  EXPECT_EQ(message_with("remove 3", "relocate 3"), "line 5: there is no such operation");
  EXPECT_EQ(message_with("remove 3", ""), "line 5: there is a superfluous space");
  EXPECT_EQ(message_with("end 3", "end 5"), "line 6: there are not as many operations");
  EXPECT_EQ(message_with("record ", "record 0"), "line 7: a hash does not have 64 digits");
  std::string longer = text + "\n";
  EXPECT_THROW(Isotopy_certificate{longer}, std::invalid_argument);
  for(std::size_t size = 13; size < text.size(); ++size)
    EXPECT_THROW(Isotopy_certificate{text.substr(0, size)}, std::invalid_argument);
}

TEST(Certificate, has_no_text_form_if_it_is_damaged)
{
  EXPECT_THROW(Isotopy_certificate().text(), std::invalid_argument);
  EXPECT_THROW(Isotopy_certificate("arbitrary").text(), std::invalid_argument);
  std::string bytes = small_certificate().bytes();
  bytes.pop_back();
  EXPECT_THROW(Isotopy_certificate(bytes).text(), std::invalid_argument);
}

TEST(Certificate, encodes_all_numbers)
{
  internal::Certificate_writer writer;
  writer.write(internal::Certificate_header());
  std::vector<Operation> operations;
  for(const std::uint64_t v : {0ull, 15ull, 16ull, 1ull << 32, 2000ull, (1ull << 60) - 1, 3ull})
    for(const std::uint64_t w : {v, v + 1, std::uint64_t(0), std::uint64_t(1) << 40})
      operations.push_back({Kind::INSERT, v, w, {-0., 5e-324, 1e308}});
  for(const Operation& operation : operations) writer.write(operation);
  internal::Certificate_reader reader(writer.bytes());
  reader.header();
  for(const Operation& operation : operations) {
    const Operation read = reader.operation();
    EXPECT_EQ(read.kind, operation.kind);
    EXPECT_EQ(read.node, operation.node);
    EXPECT_EQ(read.other, operation.other);
    EXPECT_EQ(read.position, operation.position);
  }
}

// Otherwise a certificate could be altered without a change of its content.
TEST(Certificate, has_one_encoding_only)
{
  const std::string header = small_certificate().bytes().substr(0, 68);
  const auto read = [&](const std::string& operation) {
    const std::string bytes = header + operation;
    internal::Certificate_reader reader(bytes);
    reader.header();
    return reader.operation();
  };
  EXPECT_EQ(read("\x06").node, static_cast<std::uint64_t>(-1));
  using Error = internal::Certificate_format_error;
  EXPECT_THROW(read(std::string("\x86\x00", 2)), Error);
  EXPECT_THROW(read(std::string(9, '\xff') + "\x02"), Error);
  EXPECT_THROW(read(std::string(10, '\xff')), Error);
  EXPECT_THROW(read("\x0b"), Error);
  EXPECT_THROW(read(""), Error);
}

TEST(Certificate, belongs_to_the_curve_not_to_the_numbering)
{
  const Network curve = square();
  const Network other({Point(1, 1, 0), Point(1, 0, -0.), Point(0, 1, 0), Point(0, 0, 0)},
                      {{1, 0}, {1, 3}, {3, 2}, {0, 2}});
  EXPECT_EQ(internal::Canonical_curve(curve).digest(), internal::Canonical_curve(other).digest());
  const Network crossed({Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)},
                        {{0, 2}, {2, 1}, {1, 3}, {3, 0}});
  EXPECT_NE(internal::Canonical_curve(curve).digest(), internal::Canonical_curve(crossed).digest());
}

TEST(Certificate, counts_components)
{
  const auto components = [](const Network& curve) {
    return internal::Canonical_curve(curve).number_of_components();
  };
  EXPECT_EQ(components(square()), 1u);
  EXPECT_EQ(components(Network()), 0u);
  Random random(2);
  for(int k = 0; k < 200; ++k) {
    const Network curve = to_network(random_curve(4, false, random));
    EXPECT_EQ(components(curve), curve.number_of_components());
  }
}

TEST(Recording, is_off_unless_it_is_asked_for)
{
  Network curve = square();
  Guard guard(curve);
  EXPECT_FALSE(guard.is_recording());
  guard.start_recording();
  EXPECT_TRUE(guard.is_recording());
  guard.stop_recording();
  EXPECT_FALSE(guard.is_recording());
}

TEST(Recording, does_not_contain_what_was_refused_or_did_nothing)
{
  Network curve = square();
  Guard guard(curve);
  guard.start_recording();
  EXPECT_FALSE(guard.move_node(0, Point(2, 0, 0)));
  EXPECT_TRUE(guard.move_node(0, Point(0, 0, 0)));
  EXPECT_FALSE(guard.insert_node(0, Point(2, 0, 0)));
  Targets still(4, 3);
  still << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  EXPECT_EQ(guard.move_nodes(still), 1);
  EXPECT_TRUE(take_apart(guard.certificate()).operations.empty());
}

TEST(Recording, can_start_anew)
{
  Network curve = square();
  Guard guard(curve);
  guard.start_recording();
  guard.move_node(0, Point(-1, 0, 0));
  const Network middle = curve;
  guard.start_recording();
  guard.move_node(2, Point(1, 2, 0));
  EXPECT_EQ(take_apart(guard.certificate()).operations.size(), 1u);
  EXPECT_TRUE(verify_certificate(guard.certificate(), middle, curve).is_valid);
  EXPECT_FALSE(verify_certificate(guard.certificate(), square(), curve).is_valid);
}

} // namespace test_certificate
