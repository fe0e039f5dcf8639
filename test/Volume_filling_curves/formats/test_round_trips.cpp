// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/writers.h"
#include "support/curve_formats_test_support.h"
#include "support/round_trip_test_support.h"

#include <gtest/gtest.h>

#include <string>

namespace test_round_trips {

using namespace curve_formats_test;
using namespace round_trip_test;

TEST(Round_trip, is_exact_to_the_last_bit_in_all_formats)
{
  const Folder folder;
  const Network network = arc_and_loop();
  for(const vfc::Curve_format& format : vfc::curve_formats()) {
    if(!format.is_written()) continue;
    const std::string file = folder.file("a" + std::string(format.extension));
    vfc::write_curve(file, network);
    const Reading reading = read_file(file, Closure::IF_REPEATED);
    ASSERT_TRUE(reading.is_accepted) << file;
    expect_same(network, reading.network);
    const bool has_pins = format.has_numbered_nodes;
    EXPECT_EQ(reading.network.is_pinned(7), has_pins) << file;
    EXPECT_EQ(reading.network.is_pinned(150), has_pins) << file;
  }
  EXPECT_EQ(folder.number_of_files(), 8u);
}

TEST(Round_trip, keeps_a_network_with_junctions_in_formats_with_indices)
{
  for(unsigned seed = 0; seed < 50; ++seed) {
    const Network network = network_with_junctions(seed);
    const internal::Curve_paths strands(network);
    const vfc::Node_columns columns = vfc::node_columns(network);
    for(const Reading& reading : {read_ply(vfc::to_ply(strands, columns), Junctions::ALLOWED),
                                  read_vtp(vfc::to_vtp(strands, columns), Junctions::ALLOWED)}) {
      ASSERT_TRUE(reading.is_accepted);
      expect_same(network, reading.network);
    }
  }
}

} // namespace test_round_trips
