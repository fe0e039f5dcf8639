// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_SHARED_CURVES_H
#define VFC_TEST_SHARED_CURVES_H

#include "support/csv_cells.h"
#include "support/jones_polynomial.h"
#include "support/knot_diagram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

// Test support: what the manifest of the shared data knows of its curves.
namespace shared_curves {

inline std::filesystem::path folder()
{
  return VFC_SHARED_DATA;
}

// Skips where the data is absent.
class Shared_data_test : public testing::Test
{
protected:
  void SetUp() override
  {
    if(!std::filesystem::exists(folder() / "MANIFEST.csv"))
      GTEST_SKIP() << "there is no shared data in " << folder().string();
  }
};

struct Known_curve
{
  std::string file, set, type;
  int crossing_number = 0;
  knot_test::Laurent jones;
  std::vector<std::vector<int>> linking_matrix;

  std::string path() const { return (folder() / file).string(); }
};

// Reads a polynomial of the manifest, such as "1*x^2 -1*x^8" or "1".
inline knot_test::Laurent laurent(const std::string& text)
{
  knot_test::Laurent result;
  std::istringstream terms(text);
  for(std::string term; terms >> term;) {
    const std::size_t power = term.find("*x^");
    const int exponent = power == std::string::npos ? 0 : std::stoi(term.substr(power + 3));
    result[exponent] = std::stoll(term);
  }
  return result;
}

// Reads "[[0, 1], [1, 0]]".
inline std::vector<std::vector<int>> matrix(const std::string& text)
{
  std::vector<std::vector<int>> result;
  for(std::size_t begin = text.find('[', 1); begin < text.size(); begin = text.find('[', begin)) {
    const std::size_t end = text.find(']', begin);
    std::string row = text.substr(begin + 1, end - begin - 1);
    std::replace(row.begin(), row.end(), ',', ' ');
    std::istringstream entries(row);
    result.emplace_back();
    for(int entry = 0; entries >> entry;) result.back().push_back(entry);
    begin = end;
  }
  return result;
}

// returns the curves of some sets, in the order of the manifest
inline std::vector<Known_curve> known_curves(const std::vector<std::string>& sets)
{
  std::ifstream manifest(folder() / "MANIFEST.csv");
  std::string line;
  std::getline(manifest, line);
  std::map<std::string, std::size_t> column;
  for(const std::string& name : csv_cells(line)) column.emplace(name, column.size());
  std::vector<Known_curve> result;
  while(std::getline(manifest, line)) {
    const std::vector<std::string> field = csv_cells(line);
    const std::string& set = field[column["set"]];
    if(std::find(sets.begin(), sets.end(), set) == sets.end()) continue;
    const std::string& crossings = field[column["crossings"]];
    result.push_back({field[column["file"]], set, field[column["type"]],
                      crossings.empty() ? 0 : std::stoi(crossings), laurent(field[column["jones"]]),
                      matrix(field[column["linking"]])});
  }
  return result;
}

// returns an open curve, closed far away: its ends are drawn out straight from the middle of the
// curve, and joined there by an arc. The manifest's types of open curves are those of this closure.
inline knot_test::Loop closed_far_away(const std::vector<knot_test::Point>& path)
{
  using knot_test::Point;
  Point middle = {0, 0, 0};
  for(const Point& p : path)
    for(std::size_t k = 0; k < 3; ++k) middle[k] += p[k] / static_cast<double>(path.size());
  const auto distance = [&](const Point& p) {
    return std::hypot(p[0] - middle[0], p[1] - middle[1], p[2] - middle[2]);
  };
  double radius = 0;
  for(const Point& p : path) radius = (std::max)(radius, 20 * distance(p));
  // from the last end (t = 0) to the first one, pushed outwards
  const auto on_arc = [&](double t) {
    Point p = middle;
    for(std::size_t k = 0; k < 3; ++k)
      p[k] += (1 - t) * (path.back()[k] - middle[k]) / distance(path.back()) +
              t * (path.front()[k] - middle[k]) / distance(path.front());
    const double scale = radius / distance(p);
    for(std::size_t k = 0; k < 3; ++k) p[k] = middle[k] + scale * (p[k] - middle[k]);
    return p;
  };
  constexpr int pieces = 32;
  knot_test::Loop loop = path;
  for(int k = 0; k <= pieces; ++k) loop.push_back(on_arc(static_cast<double>(k) / pieces));
  return loop;
}

} // namespace shared_curves

#endif // VFC_TEST_SHARED_CURVES_H
