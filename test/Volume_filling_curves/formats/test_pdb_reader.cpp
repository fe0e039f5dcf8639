// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/curve_formats_test_support.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

// The backbones of proteins.
namespace test_pdb_reader {

using namespace curve_formats_test;

std::string atom(
    const std::string& record, const std::string& name, char chain, int residue, double x)
{
  std::string line(54, ' ');
  const auto set = [&](std::size_t column, const std::string& text) {
    line.replace(column - 1, text.size(), text);
  };
  set(1, record);
  set(13, name);
  line[21] = chain;
  set(23, std::to_string(1000 + residue));
  set(31, std::to_string(x).substr(0, 8));
  set(39, std::to_string(0.5 * residue).substr(0, 8));
  set(47, std::to_string(0.1 * residue * residue).substr(0, 8));
  return line + '\n';
}

TEST(Pdb_reader, reads_the_alpha_atoms_of_each_chain_of_the_first_model)
{
  const std::string text =
      "HEADER    A PROTEIN\nMODEL        1\n" + atom("ATOM", " N  ", 'A', 0, 1) +
      atom("ATOM", " CA ", 'A', 0, 0) + atom("ATOM", " CA ", 'A', 0, 0.1) /* alternate */ +
      atom("HETATM", " CA ", 'A', 1, 3) /* selenomethionine */ + atom("ATOM", " CA ", 'A', 2, 6) +
      "TER\n" + atom("ATOM", " CA ", 'B', 0, 20) + atom("ATOM", " CA ", 'B', 1, 23) + "TER\n" +
      atom("HETATM", "CA  ", 'A', 7, 30) /* calcium */ + atom("HETATM", " CA ", 'B', 8, 33) +
      "ENDMDL\nMODEL        2\n" + atom("ATOM", " CA ", 'A', 0, 7) + "ENDMDL\nEND\n";
  const Reading reading = read_pdb(text);
  ASSERT_TRUE(reading.is_accepted);
  ASSERT_EQ(reading.network.number_of_components(), 2u);
  EXPECT_EQ(reading.network.number_of_nodes(), 5u);
  EXPECT_EQ(reading.network.point(1), Network::Point_3(3, 0.5, 0.1));
  EXPECT_TRUE(reading.defects.empty());
}

// Where a chain begins with a residue that is no standard one.
TEST(Pdb_reader, takes_all_residues_of_a_chain_after_the_end_of_another)
{
  const std::string text = atom("ATOM", " CA ", 'A', 0, 0) + atom("ATOM", " CA ", 'A', 1, 3) +
                           "TER\n" + atom("HETATM", " CA ", 'B', 0, 20) +
                           atom("ATOM", " CA ", 'B', 1, 23) + "TER\n" +
                           atom("HETATM", " CA ", 'A', 9, 40) + "END\n";
  const Reading reading = read_pdb(text);
  ASSERT_TRUE(reading.is_accepted);
  EXPECT_EQ(reading.network.number_of_nodes(), 4u);
  EXPECT_EQ(reading.network.number_of_components(), 2u);
  EXPECT_TRUE(reading.defects.empty());
}

TEST(Pdb_reader, reads_the_phosphorus_of_nucleic_acids)
{
  const std::string text =
      atom("ATOM", " O5'", 'A', 0, 0) + atom("ATOM", " P  ", 'A', 1, 6) +
      atom("ATOM", " C1'", 'A', 1, 7) + atom("HETATM", " P  ", 'A', 2, 12) /* modified */ +
      atom("ATOM", " P  ", 'A', 3, 18) + "TER\n" + atom("ATOM", " P  ", 'B', 0, 50) +
      atom("ATOM", " P  ", 'B', 1, 57.5) + "TER\n" + atom("HETATM", " P  ", 'A', 9, 80) +
      atom("HETATM", " P  ", 'C', 1, 90) /* a ligand */ + "END\n";
  const Reading reading = read_pdb(text);
  ASSERT_TRUE(reading.is_accepted);
  ASSERT_EQ(reading.network.number_of_components(), 2u);
  EXPECT_EQ(reading.network.number_of_nodes(), 5u);
  EXPECT_EQ(reading.network.point(0), Network::Point_3(6, 0.5, 0.1));
  EXPECT_TRUE(reading.defects.empty()) << "P atoms are up to 7.5 Angstrom apart";
}

TEST(Pdb_reader, leaves_out_the_phosphorus_of_proteins)
{
  const Reading reading = read_pdb(
      atom("ATOM", " CA ", 'A', 0, 0) + atom("HETATM", " CA ", 'A', 1, 3) +
      atom("HETATM", " P  ", 'A', 1, 5) /* phosphoserine */ + atom("ATOM", " CA ", 'A', 2, 6) +
      atom("ATOM", " P  ", 'B', 0, 30) + atom("ATOM", " P  ", 'B', 1, 36) + "END\n");
  ASSERT_TRUE(reading.is_accepted);
  EXPECT_EQ(reading.network.number_of_nodes(), 5u);
  EXPECT_EQ(reading.network.number_of_components(), 2u);
  EXPECT_TRUE(reading.defects.empty());
}

TEST(Pdb_reader, says_where_a_file_is_wrong_and_where_residues_are_missing)
{
  EXPECT_EQ(complaint(read_pdb("HEADER\nEND\n")),
            "2: there are no C-alpha or P atoms (records ATOM)");
  std::string bad = atom("ATOM", " CA ", 'A', 0, 0) + atom("ATOM", " CA ", 'A', 1, 3);
  bad.replace(bad.size() - 25, 8, "    ****");
  EXPECT_EQ(complaint(read_pdb(bad)), "2: '****' is not a number");
  const Reading gap =
      read_pdb(atom("ATOM", " CA ", 'A', 0, 0) + atom("ATOM", " CA ", 'A', 5, 19) + "END\n");
  ASSERT_TRUE(gap.is_accepted);
  ASSERT_EQ(gap.defects.size(), 1u);
  EXPECT_EQ(gap.defects[0].kind, Curve_defect_kind::CHAIN_GAP);
  EXPECT_EQ(gap.defects[0].line, 2u);
  EXPECT_EQ(gap.defects[0].nodes, (std::vector<std::size_t>{1, 2}));
  EXPECT_NE(gap.defects[0].message.find("between A 1000 and A 1005"), std::string::npos)
      << gap.defects[0].message;
}

} // namespace test_pdb_reader
