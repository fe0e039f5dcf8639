// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Formats for programs that color curves: PLY, VTP and PVD.

#include "formats/Node_columns.h"
#include "formats/writers.h"
#include "support/curve_formats_test_support.h"
#include "support/shared_curves.h"

#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/generators.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace test_value_formats {

using namespace curve_formats_test;

const std::string square_ply = "ply\nformat ascii 1.0\ncomment a square\nelement vertex 4\n"
                               "property float z\nproperty double x\nproperty double y\n"
                               "element edge 4\nproperty int vertex1\nproperty int vertex2\n"
                               "property uchar red\nend_header\n";
const std::string square_points = "0 0 0\n0 1 0\n0 1 1\n0 0 1\n";
const std::string square_edges = "0 1 9\n1 2 9\n2 3 9\n3 0 9\n";

TEST(Ply_reader, finds_coordinates_and_edges_among_other_properties)
{
  const Reading reading = read_ply(square_ply + square_points + square_edges);
  ASSERT_TRUE(reading.is_accepted);
  EXPECT_TRUE(reading.network.is_closed(0));
  EXPECT_EQ(reading.network.point(1), Network::Point_3(1, 0, 0));
  EXPECT_TRUE(reading.defects.empty());
}

TEST(Ply_reader, takes_vertices_without_edges_for_a_loop)
{
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n"
                             "property double y\nproperty double z\nelement face ";
  const std::string list = "\nproperty list uchar int vertex_indices\nend_header\n";
  const Reading loop = read_ply(header + "0" + list + "0 0 0\n1 0 0\n0 1 0\n");
  ASSERT_TRUE(loop.is_accepted);
  EXPECT_EQ(loop.defects.at(0).kind, Curve_defect_kind::NO_LINES);
  EXPECT_EQ(complaint(read_ply(header + "1" + list + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")),
            "13: there are faces but no lines");
}

TEST(Ply_reader, says_where_a_file_is_wrong)
{
  EXPECT_EQ(complaint(read_ply("")), "1: the first word is not ply");
  EXPECT_EQ(complaint(read_ply("ply\nformat xml 1.0\nend_header\n")),
            "2: 'xml' is no format of PLY");
  EXPECT_EQ(complaint(read_ply(square_ply + "0 0 \x01\n")),
            "13: byte 1 does not belong in a text file");
  EXPECT_EQ(complaint(read_ply("ply\nformat ascii 1.0\n\x01")),
            "3: byte 1 does not belong in a text file");
  EXPECT_EQ(complaint(read_ply("ply\nformat ascii 1.0\n")), "3: the header has no end_header");
  EXPECT_EQ(complaint(read_ply("ply\nformat ascii 1.0\nelement vertex many\n")),
            "3: 'many' is not a number of items");
  EXPECT_EQ(complaint(read_ply("ply\nproperty double x\n")),
            "2: a property comes before any element");
  EXPECT_EQ(complaint(read_ply("ply\nformat ascii 1.0\nvertex 4\n")),
            "3: 'vertex' does not belong in the header");
  EXPECT_EQ(complaint(read_ply(square_ply + square_points + "0 1 9\n1 2\n")),
            "18: the file ends within edge 2 of 4");
  EXPECT_EQ(complaint(read_ply(square_ply + square_points + "0 1 9\n")),
            "18: the file ends within edge 2 of 4");
  EXPECT_EQ(complaint(read_ply(square_ply + square_points + "0 1 9\n1 2 9\n2 4 9\n3 0 9\n")),
            "19: there is no vertex 4 (numbered from 0)");
  EXPECT_EQ(complaint(read_ply(square_ply + "0 x 0\n0 1 0\n0 1 1\n0 0 1\n" + square_edges)),
            "13: 'x' is not a number");
  EXPECT_EQ(complaint(read_ply("ply\nformat ascii 1.0\nelement vertex 18446744073709551615\n"
                               "property double x\nproperty double y\nproperty double z\n"
                               "end_header\n0 0 0\n")),
            "3: more is announced than the file can hold")
      << "and takes no memory for what is announced";
}

// The values of an item may go on in the next line, but not in one with values of the next item.
TEST(Ply_reader, tells_where_values_are_missing_or_too_many)
{
  EXPECT_TRUE(read_ply(square_ply + "0 0\n0\n0 1 0 0 1 1\n0 0\n1\n" + square_edges).is_accepted);
  EXPECT_EQ(complaint(read_ply(square_ply + "0 0 0\n0 1\n0 1 1\n0 0 1\n" + square_edges)),
            "14: vertex 2 does not end with its line");
  EXPECT_EQ(complaint(read_ply(square_ply + "0 0 0\n0 1 0 8\n0 1 1\n0 0 1\n" + square_edges)),
            "14: vertex 3 does not end with its line");
}

TEST(Ply_reader, pins_what_is_not_zero)
{
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n"
                             "property double y\nproperty double z\nproperty float pinned\n"
                             "element edge 2\nproperty int vertex1\nproperty int vertex2\n"
                             "end_header\n";
  const Network arc = read_ply(header + "0 0 0 0.0\n1 0 0 1e0\n2 0 0 0\n0 1\n1 2\n").network;
  ASSERT_EQ(arc.number_of_nodes(), 3u);
  EXPECT_FALSE(arc.is_pinned(0));
  EXPECT_TRUE(arc.is_pinned(1));
  EXPECT_FALSE(arc.is_pinned(2));
  EXPECT_EQ(complaint(read_ply(header + "0 0 0 0\n1 0 0 yes\n2 0 0 0\n0 1\n1 2\n")),
            "13: 'yes' is not a number for pinned");
}

std::string vtp(const std::string& piece)
{
  return "<?xml version='1.0'?>\n<!-- <Points> -->\n<VTKFile type = \"PolyData\">\n<PolyData>\n" +
         piece + "</PolyData>\n</VTKFile>\n";
}

std::string array(const std::string& name, const std::string& content)
{
  return "<DataArray Name=\"" + name + "\" format=\"ascii\">" + content + "</DataArray>\n";
}

std::string piece(const std::string& points, const std::string& lines, const std::string& ends)
{
  return "<Piece>\n<PointData/>\n<Points>" + array("Points", points) + "</Points>\n<Lines>" +
         array("connectivity", lines) + array("offsets", ends) + "</Lines>\n</Piece>\n";
}

TEST(Vtp_reader, reads_lines_of_pieces)
{
  const std::string first =
      piece("0 0 0 1 0 0\n0 1 0<InformationKey name='x'>7</InformationKey>", "0 1 2 0", "4");
  const std::string second = piece("0 0 1 1 0 1 1 0 2 3 0 2", "0 1 2 3", "2 4");
  const Reading reading = read_vtp(vtp(first + second));
  ASSERT_TRUE(reading.is_accepted);
  ASSERT_EQ(reading.network.number_of_components(), 3u);
  EXPECT_TRUE(reading.network.is_closed(0));
  EXPECT_EQ(reading.network.point(6), Network::Point_3(3, 0, 2));
}

// A section without contents ends where it begins.
TEST(Vtp_reader, does_not_take_vertices_for_lines)
{
  const Reading reading = read_vtp(vtp(
      "<Piece>\n<Points>" + array("Points", "0 0 0 1 0 0 0 1 0") + "</Points>\n<Lines/>\n<Verts>" +
      array("connectivity", "0 1") + array("offsets", "2") + "</Verts>\n</Piece>\n"));
  ASSERT_TRUE(reading.is_accepted);
  EXPECT_TRUE(reading.network.is_closed(0));
  EXPECT_EQ(reading.network.number_of_edges(), 3u);
}

TEST(Vtp_reader, says_where_a_file_is_wrong)
{
  const std::string points = "0 0 0 1 0 0 0 1 0";
  EXPECT_EQ(complaint(read_vtp("")), "1: the first tag is not <VTKFile type=\"PolyData\">");
  EXPECT_EQ(complaint(read_vtp("<VTKFile type=\"ImageData\">")),
            "1: the first tag is not <VTKFile type=\"PolyData\">");
  EXPECT_EQ(complaint(read_vtp("<VTKFile type=\"PolyData\">\n<Piece>\n")),
            "3: the file ends before </VTKFile>");
  EXPECT_EQ(complaint(read_vtp(vtp(piece("0 0 0 1 0", "0 1", "2")))),
            "7: the number of coordinates is no multiple of 3");
  EXPECT_EQ(complaint(read_vtp(vtp(piece("0 0 0 1 0 0 0 o 0", "0 1 2", "3")))),
            "7: 'o' is not a number");
  for(const std::string word : {"yes", "nan"}) {
    const std::string pinned =
        "<PointData>" + array("pinned", "0 " + word + " 0") + "</PointData>\n";
    const std::string start = "<Piece>\n";
    EXPECT_EQ(
        complaint(read_vtp(vtp(start + pinned + piece(points, "0 1 2", "3").substr(start.size())))),
        "6: '" + word + "' is not a number for pinned");
  }
  EXPECT_EQ(complaint(read_vtp(vtp(piece(points, "0\n1\n3", "3")))),
            "11: '3' is not the index of one of 3 points");
  EXPECT_EQ(complaint(read_vtp(vtp(piece(points, "0 1 2", "2 1")))),
            "10: '1' is no place where a line of 3 indices can end");
  EXPECT_EQ(complaint(read_vtp(vtp("<Piece>\n<Points>\n<DataArray format=\"binary\">AAAA"
                                   "</DataArray></Points></Piece>"))),
            "7: an array is longer than its data in the file");
  EXPECT_EQ(complaint(read_vtp(vtp("<Piece>\n<Points>\n<DataArray format='appended' offset='0'/>"
                                   "</Points></Piece>"))),
            "7: the appended data do not begin with '_'");
  EXPECT_EQ(complaint(read_vtp(vtp("<Piece>\n<Points>" + array("", points) + "</Points>\n<Polys>" +
                                   array("connectivity", "0 1 2") + "</Polys></Piece>"))),
            "8: there are faces but no lines");
}

TEST(Node_columns, are_columns_of_a_file)
{
  const std::string arc = "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 2 0 0\nl 2 3 4\nfixed 3\n";
  const Network network = read_obj(arc).network; // without the vertex that has no edge
  vfc::Node_columns columns = vfc::node_columns(network);
  columns.push_back({"radius", {0.5, 0.25, 0.125}});
  EXPECT_EQ(vfc::to_ply(internal::Curve_paths(network), columns),
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n"
            "property double y\nproperty double z\nproperty double origin\n"
            "property int component\nproperty double curvature\n"
            "property double radius\nproperty uchar pinned\nelement edge 2\n"
            "property int vertex1\nproperty int vertex2\nend_header\n"
            "0 0 0 1 0 0 0.5 0\n1 0 0 2 0 0 0.25 1\n2 0 0 3 0 0 0.125 0\n"
            "0 1\n1 2\n");
}

TEST(Node_columns, have_the_reciprocals_of_the_bend_radii)
{
  const Network polygon = make_regular_polygon(40, 3);
  const vfc::Node_columns columns = vfc::node_columns(polygon);
  ASSERT_EQ(columns[2].name, "curvature");
  for(const double curvature : columns[2].values)
    EXPECT_NEAR(curvature, max_curvature(polygon), 1e-9);
}

TEST(Node_columns, have_origins_between_the_nodes_of_the_input)
{
  Network network = read_obj(square + "l 1 2 3 4 1\n").network;
  {
    Isotopy_guard_3 guard(network);
    ASSERT_TRUE(guard.insert_node(3, Network::Point_3(0, 0.25, 0.5))); // of the edge from 3 to 0
    guard.collect_garbage();
  }
  const vfc::Node_columns columns = vfc::node_columns(network);
  ASSERT_EQ(columns[0].name, "origin");
  const std::vector<double>& origins = columns[0].values;
  ASSERT_EQ(origins.size(), 5u);
  for(std::size_t v = 0; v < 4; ++v) EXPECT_EQ(origins[v], double(v));
  // between them by the lengths to both
  const double before = std::hypot(0.75, 0.5), behind = std::hypot(0.25, 0.5);
  EXPECT_NEAR(origins[4], 3 + before / (before + behind), 1e-12);
}

using Shared_value_formats = shared_curves::Shared_data_test;

TEST_F(Shared_value_formats, a_protein_is_an_arc)
{
  const auto file = shared_curves::folder() / "real" / "formats" / "2efv.pdb";
  const Reading reading = read_file(file.string());
  ASSERT_TRUE(reading.is_accepted);
  const Network& network = reading.network;
  EXPECT_EQ(network.number_of_components(), 1u);
  EXPECT_EQ(network.number_of_nodes(), 82u);
  EXPECT_FALSE(network.is_closed(0));
}

} // namespace test_value_formats
