// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Feeds arbitrary bytes, and words chosen by them, to the readers of curve files. Whatever they
// accept must come back unchanged from a file. Build with clang++
// -fsanitize=fuzzer,address,undefined.

#include "formats/curve_formats.h"

#include <CGAL/Volume_filling_curves/IO/curve_network.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace CGAL::Volume_filling_curves;
using Network = Curve_network_3<>;

void require(bool condition)
{
  if(!condition) std::abort();
}

bool have_same_bits(double x, double y)
{
  return std::memcmp(&x, &y, sizeof(double)) == 0;
}

void require_same(const Network& a, const Network& b)
{
  require(a.number_of_nodes() == b.number_of_nodes());
  require(a.number_of_edges() == b.number_of_edges());
  require(a.number_of_components() == b.number_of_components());
  for(std::size_t v = 0; v < a.number_of_nodes(); ++v) {
    for(int k = 0; k < 3; ++k) require(have_same_bits(a.point(v)[k], b.point(v)[k]));
    require(a.component(v) == b.component(v) && a.degree(v) == b.degree(v));
  }
  for(std::size_t e = 0; e < a.number_of_edges(); ++e)
    require(a.source(e) == b.source(e) && a.target(e) == b.target(e));
}

bool read(internal::Curve_draft file, Junctions junctions, Network& network)
{
  std::vector<Curve_defect> defects;
  const bool is_accepted = internal::draft_to_embedded_network(file, network, defects, junctions);
  bool has_error = false;
  for(const Curve_defect& defect : defects) {
    has_error = has_error || is_error(defect.kind);
    require(to_string(defect, "file").find('\n') == std::string::npos);
  }
  require(is_accepted != has_error);
  return is_accepted;
}

void require_round_trip(const Network& network, Junctions junctions)
{
  require(network.number_of_nodes() >= 2);
  const internal::Curve_paths strands(network);
  for(const vfc::Curve_format& format : vfc::curve_formats()) {
    if(!format.is_written()) continue;
    const std::string text = format.write != nullptr
                                 ? format.write(strands)
                                 : format.write_with_columns(strands, vfc::node_columns(network));
    internal::Curve_draft draft = format.read(text, junctions);
    draft.says_what_is_closed = true;
    Network copy;
    require(read(draft, junctions, copy));
    if(format.has_numbered_nodes || !network.has_junction())
      require_same(network, copy);
    else if(format.extension == ".polylines.txt")
      require(network.number_of_edges() == copy.number_of_edges());
    for(std::size_t v = 0; format.has_numbered_nodes && v < network.number_of_nodes(); ++v)
      require(network.is_pinned(v) == copy.is_pinned(v));
  }
}

// Reads a text in all formats, with and without junctions.
void run(std::string_view text)
{
  for(const Junctions junctions : {Junctions::FORBIDDEN, Junctions::ALLOWED}) {
    for(const vfc::Curve_format& format : vfc::curve_formats()) {
      Network network;
      if(read(format.read(text, junctions), junctions, network))
        require_round_trip(network, junctions);
    }
  }
}

using Words = std::vector<std::string>;

// Every byte is a word; such texts get further than arbitrary ones.
std::string words(const Words& choice, const std::uint8_t* data, std::size_t size)
{
  std::string text;
  for(std::size_t i = 0; i < size; ++i) text += choice[data[i] % choice.size()];
  return text;
}

const Words words_of_lists = {"\nv 0 0 0", "\nv 1 0 0",
                              "\nv 0 1 0", "\nv 1 1 0",
                              "\nv 0 0 1", "\nv 1 0 1",
                              "\nv 3 1 2", "\nv 2 .5 9",
                              "\nv",       "\nl",
                              "\nl",       "\nl 1 2",
                              "\nl -1 -2", "\nfixed",
                              "\n",        "\r",
                              " \\\n",     " 0",
                              " 1",        " 2",
                              " 3",        " 4",
                              " 5",        " 6",
                              " 1 2 3 1",  " 0 0 0 1 1",
                              " -1",       " -2",
                              "/1",        " 1e-160",
                              " 1e149",    " 1e-320",
                              " nan",      "\n4 0 0 0 1 0",
                              "\n2",       "\n3",
                              " #",        "\nf 1 2 3",
                              " 1 0 0",    " 0 1 0",
                              " 0 0 1"};

const Words words_of_ply = {"ply\nformat ascii 1.0\n",
                            "ply\nformat binary_little_endian 1.0\n",
                            "ply\nformat binary_big_endian 1.0\n",
                            "element vertex 3\n",
                            "element vertex ",
                            "element edge 2\n",
                            "element edge ",
                            "element face 1\n",
                            "property double x\n",
                            "property double y\n",
                            "property double z\n",
                            "property uchar pinned\n",
                            "property int vertex1\nproperty int vertex2\n",
                            "property list uchar int vertex_indices\n",
                            "comment\n",
                            "end_header\n",
                            "0 0 0\n",
                            "1 0 0\n",
                            "0 1 0\n",
                            "1 1 1\n",
                            "0 1\n",
                            "1 2\n",
                            "0",
                            " 1",
                            " 2",
                            " 3",
                            "\n",
                            " 1e149",
                            " -1",
                            " nan",
                            " #"};

const Words words_of_vtp = {"<VTKFile type=\"PolyData\">",
                            "<Piece>",
                            "</Piece>",
                            "</VTKFile>",
                            "<Points><DataArray>",
                            "<Lines><DataArray Name=\"connectivity\">",
                            "<DataArray Name=\"offsets\">",
                            "</DataArray>",
                            "</Points>",
                            "</Lines>",
                            "<PointData><DataArray Name=\"pinned\">",
                            "</PointData>",
                            "<Polys><DataArray>",
                            "<!--",
                            "-->",
                            "<",
                            ">",
                            "/>",
                            "=",
                            "\"",
                            "'",
                            "format=\"binary\"",
                            "\n",
                            " 0 0 0",
                            " 1 0 0",
                            " 0 1 0",
                            " 0 0 1",
                            " 0",
                            " 1",
                            " 2",
                            " 3",
                            " 4",
                            " nan",
                            " -1"};

const Words words_of_pdb = {"ATOM      1  CA  GLY A   1    ",
                            "ATOM      1  CA AGLY A   2    ",
                            "HETATM    1  CA  MSE A   3    ",
                            "ATOM      1  CA  GLY B   4    ",
                            "ATOM      1  N   GLY B   5    ",
                            "   1.000",
                            "   2.000",
                            "   0.500",
                            "   9.000",
                            "     nan",
                            "\n",
                            "\r\n",
                            "TER\n",
                            "MODEL\n",
                            "ENDMDL\n",
                            "END\n",
                            " "};

const Words words_of_mmcif = {"loop_\n",
                              "_atom_site.label_atom_id\n",
                              "_atom_site.label_asym_id\n",
                              "_atom_site.label_seq_id\n",
                              "_atom_site.Cartn_x\n",
                              "_atom_site.Cartn_y\n",
                              "_atom_site.Cartn_z\n",
                              "_atom_site.auth_seq_id\n",
                              "_atom_site.pdbx_PDB_model_num\n",
                              "data_\n",
                              " CA A 1 0 0 0",
                              " CA A 2 1 0 0",
                              " 'P' B 3 0 1 0",
                              "\n;",
                              "\n",
                              " \"",
                              "'",
                              " # ",
                              " .",
                              " 7"};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  run({reinterpret_cast<const char*>(data), size});
  for(const Words& choice :
      {words_of_lists, words_of_ply, words_of_vtp, words_of_pdb, words_of_mmcif})
    run(words(choice, data, size));
  return 0;
}
