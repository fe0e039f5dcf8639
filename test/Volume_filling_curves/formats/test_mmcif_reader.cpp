// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/curve_formats_test_support.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

// The backbones of proteins in mmCIF.
namespace test_mmcif_reader {

using namespace curve_formats_test;

const std::string head = "data_TEST\n"
                         "_entry.id TEST # a comment\n"
                         "_struct.title 'it''s _atom_site.Cartn_x loop_'\n"
                         "_struct.details\n"
                         ";text of lines\nloop_\n_atom_site.id\n;\n"
                         "loop_\n_entity.id\n_entity.type\n1 polymer\n2 'non-polymer'\n#\n"
                         "loop_\n_atom_site.group_PDB\n_atom_site.type_symbol\n"
                         "_atom_site.label_atom_id\n_atom_site.label_alt_id\n"
                         "_atom_site.label_asym_id\n_atom_site.label_seq_id\n"
                         "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
                         "_atom_site.auth_seq_id\n_atom_site.auth_asym_id\n"
                         "_atom_site.pdbx_PDB_model_num\n";
constexpr std::size_t lines_of_head = 27;

// An atom of chain A is one of chain X for the authors.
std::string atom(
    const std::string& name, char chain, const std::string& position, double x, int model = 1)
{
  const std::string element = name == "CAL" ? "CA" : name.substr(0, 1);
  return "ATOM " + element + ' ' + (name == "CAL" ? "CA" : name) + " . " + chain + ' ' + position +
         ' ' + std::to_string(x) + " 0.5 -1.25 10" + position + ' ' + (chain == 'A' ? 'X' : chain) +
         ' ' + std::to_string(model) + '\n';
}

TEST(Mmcif_reader, reads_the_alpha_atoms_of_each_chain_of_the_first_model)
{
  const Reading reading =
      read_mmcif(head + atom("N", 'A', "1", -1) + atom("CA", 'A', "1", 0) +
                 atom("CA", 'A', "2", 3) + atom("CA", 'A', "2", 3.1) /* alternate */ +
                 atom("CA", 'A', "3", 6) + atom("CA", 'B', "1", 20) + atom("CA", 'B', "2", 23) +
                 atom("CAL", 'C', ".", 30) + atom("CA", 'D', ".", 31) /* a ligand */ +
                 atom("CA", 'A', "4", 9, 2) + "#\nloop_\n_other.id\n1\n2\n");
  ASSERT_TRUE(reading.is_accepted);
  EXPECT_TRUE(reading.defects.empty());
  ASSERT_EQ(reading.network.number_of_components(), 2u);
  EXPECT_EQ(reading.network.number_of_nodes(), 5u);
  EXPECT_EQ(reading.network.point(1), Network::Point_3(3, 0.5, -1.25));
  EXPECT_FALSE(reading.network.is_closed(0));
}

TEST(Mmcif_reader, reads_nucleic_acids_with_quoted_names_in_any_order_of_columns)
{
  const Reading reading = read_mmcif("data_x\nloop_\n_atom_site.Cartn_z\n_atom_site.Cartn_y\n"
                                     "_atom_site.Cartn_x\n_atom_site.label_atom_id\n"
                                     "_atom_site.label_seq_id\n_atom_site.label_asym_id\n"
                                     "1 2 3 \"O5'\" 1 A\n1 2 3 P 1 A 1 2\n9 P 2 A\n"
                                     "1 2 9.5 'C5'' 2 A\n");
  ASSERT_TRUE(reading.is_accepted);
  EXPECT_EQ(reading.network.number_of_nodes(), 2u);
  EXPECT_EQ(reading.network.point(1), Network::Point_3(9, 2, 1));
}

TEST(Mmcif_reader, names_residues_at_gaps_as_authors_do)
{
  const Reading gap = read_mmcif(head + atom("CA", 'A', "1", 0) + atom("CA", 'A', "7", 19) + "#\n");
  ASSERT_TRUE(gap.is_accepted);
  ASSERT_EQ(gap.defects.size(), 1u);
  EXPECT_EQ(gap.defects[0].kind, Curve_defect_kind::CHAIN_GAP);
  EXPECT_EQ(gap.defects[0].line, lines_of_head + 2);
  EXPECT_NE(gap.defects[0].message.find("between X 101 and X 107"), std::string::npos)
      << gap.defects[0].message;
}

TEST(Mmcif_reader, says_where_a_file_is_wrong)
{
  EXPECT_EQ(complaint(read_mmcif("data_x\n")),
            "2: there are no C-alpha or P atoms of chains (table atom_site)");
  EXPECT_EQ(complaint(read_mmcif("loop_\n_atom_site.label_atom_id\n_atom_site.label_asym_id\n"
                                 "_atom_site.label_seq_id\n_atom_site.Cartn_x\nCA A 1 0\n")),
            "2: the table atom_site has no column Cartn_y");
  const std::string two = head + atom("CA", 'A', "1", 0) + atom("CA", 'A', "2", 3);
  std::string bad = two;
  bad.replace(bad.rfind("-1.25"), 5, "?");
  EXPECT_EQ(complaint(read_mmcif(bad)),
            std::to_string(lines_of_head + 2) + ": '?' is not a number");
  EXPECT_EQ(complaint(read_mmcif(two + "ATOM C CA . A 3 6 0")),
            std::to_string(lines_of_head + 3) + ": the last row of atom_site is incomplete");
}

} // namespace test_mmcif_reader
