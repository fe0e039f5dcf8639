// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Regina's polynomials: of the prime knots of up to 10 crossings, as the shared data has them, and
// of random diagrams, if Regina is installed.

#include "support/braid_diagrams.h"
#include "support/shared_curves.h"

#include <CGAL/Volume_filling_curves/internal/diagrams/Homfly_polynomial.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/colored_jones_polynomial.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace test_polynomials_against_regina {

namespace VFC = CGAL::Volume_filling_curves;

using namespace VFC::internal;
using namespace knot_test;
using VFC::Planar_diagram;

// Reads a sum such as "x^-2 y^2 - 2 x^-2 - x^-4".
Laurent_polynomial_2 polynomial(const std::string& text)
{
  Laurent_polynomial_2 sum;
  Coefficient coefficient = 1;
  std::array<int, 2> exponents{0, 0};
  bool has_term = false;
  const auto end_term = [&] {
    if(has_term) sum.add_multiple(Laurent_polynomial_2::monomial(exponents, coefficient));
    coefficient = 1;
    exponents = {0, 0};
    has_term = false;
  };
  std::istringstream words(text);
  for(std::string word; words >> word;) {
    if(word == "+" || word == "-") {
      end_term();
      coefficient = word == "+" ? 1 : -1;
      continue;
    }
    if(word.front() == '-') coefficient = -1;
    word.erase(0, word.front() == '-' ? 1 : 0);
    has_term = true;
    const std::size_t power = word.find('^');
    if(word.front() != 'x' && word.front() != 'y')
      coefficient *= std::stol(word);
    else
      exponents[word.front() == 'x' ? 0 : 1] =
          power == std::string::npos ? 1 : std::stoi(word.substr(power + 1));
  }
  end_term();
  return sum;
}

// P in the variables of Lickorish and Millett, x = i / v and y = -i z: v^a z^b = i^(a+b) x^-a y^b.
Laurent_polynomial_2 in_their_variables(const Laurent_polynomial_2& p)
{
  Laurent_polynomial_2 result;
  for(const auto& term : p.terms()) {
    const auto [a, b] = term.exponents;
    const Coefficient sign = (a + b) % 4 == 0 ? 1 : -1;
    result.add_multiple(Laurent_polynomial_2::monomial({-a, b}, sign * term.coefficient));
  }
  return result;
}

Laurent_polynomial_2 in_two_variables(const Laurent_polynomial& p)
{
  Laurent_polynomial_2 result;
  for(int e = p.low(); e < p.end(); ++e)
    result.add_multiple(Laurent_polynomial_2::monomial({e, 0}, p[e]));
  return result;
}

// The strings in quotes of a line of JSON.
std::vector<std::string> strings(std::istream& in)
{
  std::vector<std::string> result;
  while(in.ignore(std::numeric_limits<std::streamsize>::max(), '"') && !in.eof()) {
    result.emplace_back();
    std::getline(in, result.back(), '"');
  }
  return result;
}

using Shared_polynomials = shared_curves::Shared_data_test;

TEST_F(Shared_polynomials, Prime_knots_and_their_mirror_images_have_the_polynomials_of_regina)
{
  std::ifstream in(shared_curves::folder() / "knots/invariants.json");
  if(!in) GTEST_SKIP() << "there are no invariants in the shared data";
  const std::vector<std::string> facts = strings(in); // name, P, 2-cable, P, 2-cable of the mirror
  const auto knots = prime_knots(VFC_DATA_DIR "/prime_knots.txt");
  ASSERT_EQ(facts.size(), 5 * knots.size());
  for(std::size_t i = 0; i < knots.size(); ++i) {
    ASSERT_EQ(facts[5 * i], knots[i].name);
    for(const bool is_mirror : {false, true}) {
      const std::size_t k = 5 * i + (is_mirror ? 3 : 1);
      const Planar_diagram diagram = closure(is_mirror ? mirrored(knots[i].braid) : knots[i].braid);
      EXPECT_EQ(in_their_variables(homfly_polynomial(diagram).value()), polynomial(facts[k]))
          << knots[i].name;
      const Laurent_polynomial jones = colored_jones_polynomial(diagram, 2).value();
      EXPECT_EQ(in_two_variables(jones_of_2_cable(jones)), polynomial(facts[k + 1]))
          << knots[i].name;
    }
  }
}

std::vector<Planar_diagram> random_diagrams(std::size_t count)
{
  std::mt19937 random(5);
  std::vector<Planar_diagram> diagrams;
  while(diagrams.size() < count) {
    Planar_diagram diagram = closure(random_braid(3 + random() % 5, 3 + random() % 20, random));
    if(diagram.number_of_free_loops == 0) diagrams.push_back(std::move(diagram));
  }
  return diagrams;
}

void write_codes(const std::vector<Planar_diagram>& diagrams, const std::filesystem::path& file)
{
  std::ofstream out(file);
  for(const Planar_diagram& diagram : diagrams) {
    out << '[';
    for(const auto& x : diagram.crossings)
      out << '[' << x[0] << ',' << x[1] << ',' << x[2] << ',' << x[3] << "],";
    out << "]\n";
  }
}

TEST(Polynomials_against_regina, Random_diagrams_have_the_same)
{
  if(std::system("command -v regina-python > /dev/null") != 0) GTEST_SKIP() << "Regina is missing";
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / "vfc_polynomials_against_regina";
  fs::create_directories(folder);
  const fs::path codes = folder / "codes.txt", output = folder / "polynomials.txt";
  const auto diagrams = random_diagrams(1000);
  write_codes(diagrams, codes);
  const std::string command = "regina-python --quiet " VFC_TEST_DIR
                              "/support/regina_polynomials.py " +
                              codes.string() + " > " + output.string();
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::ifstream in(output);
  for(const Planar_diagram& diagram : diagrams) {
    std::string homfly, jones;
    ASSERT_TRUE(std::getline(in, homfly) && std::getline(in, jones));
    EXPECT_EQ(in_their_variables(homfly_polynomial(diagram).value()), polynomial(homfly));
    const Laurent_polynomial p = colored_jones_polynomial(diagram, 1).value();
    const int power = number_of_components(diagram) == 1 ? 2 : 1;
    EXPECT_EQ(in_two_variables(p.with_exponents_times(power)), polynomial(jones));
  }
}

} // namespace test_polynomials_against_regina
