// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Names of curves that others know: the shared data, and Regina's census of knots.

#include "support/braid_diagrams.h"
#include "support/shared_curves.h"

#include <CGAL/Volume_filling_curves/IO/curve_network.h>
#include <CGAL/Volume_filling_curves/identify.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/colored_jones_polynomial.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace test_identify_known_curves {

namespace VFC = CGAL::Volume_filling_curves;

using namespace knot_test;
using VFC::Link_identity;
using VFC::Planar_diagram;

// The Jones polynomial of a diagram in the square root of t, as in the manifest.
Laurent jones(const Planar_diagram& diagram)
{
  const auto p = VFC::internal::colored_jones_polynomial(diagram, 1).value();
  const int power = VFC::internal::number_of_components(diagram) == 1 ? 2 : 1;
  Laurent result;
  for(int e = p.low(); e < p.end(); ++e)
    if(p[e] != 0) result[power * e] = p[e];
  return result;
}

std::vector<int> sorted_entries(const std::vector<std::vector<int>>& matrix)
{
  std::vector<int> entries;
  for(const auto& row : matrix) entries.insert(entries.end(), row.begin(), row.end());
  std::sort(entries.begin(), entries.end());
  return entries;
}

using Identify_shared_curves = shared_curves::Shared_data_test;
using Long_identify_known_curves = shared_curves::Shared_data_test;

TEST_F(Long_identify_known_curves, Knots_have_the_names_of_the_manifest_proved_and_with_chirality)
{
  const auto table = prime_knots(VFC_DATA_DIR "/prime_knots.txt");
  const std::vector<std::string> sets{"knot128", "trefoil100", "trefoil_hard", "paper",
                                      "hard_unknots"};
  const auto curves = shared_curves::known_curves(sets);
  ASSERT_GT(curves.size(), 200u);
  for(const auto& known : curves) {
    VFC::Curve_network_3<> curve;
    ASSERT_TRUE(CGAL::IO::read_curve_network(known.path(), curve)) << known.file;
    const Link_identity identity = VFC::identify(curve);
    EXPECT_TRUE(identity.is_proved) << known.file << ": " << identity.diagram.crossings.size();
    const std::string& name = identity.name;
    EXPECT_EQ(name.substr(0, name.find('*')), known.type) << known.file;
    EXPECT_EQ(identity.knottedness == VFC::Knottedness::UNKNOTTED, known.type == "0_1");
    EXPECT_NE(identity.knottedness, VFC::Knottedness::UNKNOWN) << known.file;
    if(known.type == "0_1") continue;
    EXPECT_EQ(jones(closure(prime_knot(table, name))), known.jones) << known.file << ": " << name;
  }
}

TEST_F(Identify_shared_curves, Links_have_the_polynomials_and_linking_numbers_of_the_manifest)
{
  const auto curves = shared_curves::known_curves({"links"});
  ASSERT_FALSE(curves.empty());
  std::size_t number_of_names = 0;
  const std::map<std::string, std::string> names{
      {"hopf.obj", "2^2_1"}, {"whitehead.obj", "5^2_1"}, {"borromean.obj", "6^3_2"}};
  for(const auto& known : curves) {
    VFC::Curve_network_3<> curve;
    ASSERT_TRUE(CGAL::IO::read_curve_network(known.path(), curve)) << known.file;
    const Link_identity identity = VFC::identify(curve);
    EXPECT_EQ(identity.number_of_components, curve.number_of_components());
    EXPECT_EQ(jones(identity.diagram), known.jones) << known.file;
    const auto named = names.find(std::filesystem::path(known.file).filename().string());
    if(named != names.end()) {
      ++number_of_names;
      EXPECT_EQ(identity.name.substr(0, identity.name.find('*')), named->second);
      EXPECT_TRUE(identity.is_proved) << known.file;
    }
    EXPECT_EQ(sorted_entries(identity.linking_matrix), sorted_entries(known.linking_matrix))
        << known.file;
    EXPECT_NE(identity.knottedness, VFC::Knottedness::UNKNOTTED) << known.file;
    EXPECT_NE(identity.knottedness, VFC::Knottedness::UNKNOWN) << known.file;
  }
  EXPECT_EQ(number_of_names, names.size());
}

TEST(Identify_census, Each_knot_of_regina_has_a_name_of_its_own)
{
  namespace fs = std::filesystem;
  if(std::system("command -v regina-python > /dev/null") != 0) GTEST_SKIP() << "Regina is missing";
  const fs::path output = fs::temp_directory_path() / "vfc_regina_census.txt";
  const std::string command =
      "regina-python --quiet " VFC_TEST_DIR "/support/regina_census.py > " + output.string();
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::set<std::string> names;
  std::ifstream in(output);
  for(std::string line; std::getline(in, line);) {
    std::istringstream numbers(line);
    Planar_diagram diagram;
    std::size_t crossings = 0;
    numbers >> crossings;
    diagram.crossings.resize(crossings);
    for(auto& x : diagram.crossings) numbers >> x[0] >> x[1] >> x[2] >> x[3];
    ASSERT_TRUE(numbers);
    const Link_identity identity = VFC::identify(diagram);
    EXPECT_TRUE(identity.is_proved) << line;
    EXPECT_EQ(identity.name.substr(0, identity.name.find('_')), std::to_string(crossings));
    names.insert(identity.name.substr(0, identity.name.find('*')));
  }
  EXPECT_EQ(names.size(), 249u);
}

} // namespace test_identify_known_curves
