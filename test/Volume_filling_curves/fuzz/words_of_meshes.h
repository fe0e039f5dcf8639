// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_WORDS_OF_MESHES_H
#define VFC_TEST_WORDS_OF_MESHES_H

#include "formats/binary_numbers.h"

#include <zlib.h>

#include <cstdint>
#include <string>
#include <vector>

// What files of meshes consist of, as the fuzzer puts it together. A few words are long, so that
// two or three make a tetrahedron.

namespace mesh_words {

using Words = std::vector<std::string>;

inline const std::string four_bytes_of_zero(4, '\0');

inline const Words words_of_off = {"OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n",
                                   "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n",
                                   "OFF\n",
                                   "OFF BINARY\n",
                                   "COFF\n",
                                   "NOFF\n",
                                   "4OFF\n",
                                   "nOFF\n3\n",
                                   "STOFF\n",
                                   "4 4 0\n",
                                   "4 4 6\n",
                                   "# c\n",
                                   "0 0 0\n",
                                   "1 0 0\n",
                                   "0 1 0\n",
                                   "0 0 1\n",
                                   "3 0 2 1\n",
                                   "3 0 1 3\n",
                                   "3 1 2 3\n",
                                   "3 0 3 2\n",
                                   "4 0 1 2 3",
                                   "2 0 1\n",
                                   "0\n",
                                   " ",
                                   "\n",
                                   " 1",
                                   " 2",
                                   " 3",
                                   " -1",
                                   " nan",
                                   " 1e300",
                                   " 1e-200",
                                   " 99999999999",
                                   " 4294967295",
                                   " .5",
                                   std::string(1, '\0')};

inline const Words words_of_obj = {"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n",
                                   "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n",
                                   "v 0 0 0\n",
                                   "v 1 0 0\n",
                                   "v 0 1 0\n",
                                   "v 0 0 1\n",
                                   "f 1 3 2\n",
                                   "f 1 2 4\n",
                                   "f 2 3 4\n",
                                   "f 1 4 3\n",
                                   "f -1 -2 -3\n",
                                   "f 1/1 2/2 3/3\n",
                                   "f 1//1 2//2 3//3\n",
                                   "f 1 2 3 4\n",
                                   "f 1 2\n",
                                   "f",
                                   "v",
                                   "vt 0 0\n",
                                   "vn 0 0 1\n",
                                   "l 1 2\n",
                                   "\\\n",
                                   "#",
                                   "o a\n",
                                   "\n",
                                   " ",
                                   " 0",
                                   " 1",
                                   " 2",
                                   " 3",
                                   " 9",
                                   "/",
                                   " nan",
                                   " 1e300",
                                   " -9",
                                   " 99999999999"};

inline const Words words_of_ply = {
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty "
    "float y\nproperty float z\n",
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n",
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n",
    "ply\n",
    "format ascii 1.0\n",
    "format binary_little_endian 1.0\n",
    "format binary_big_endian 1.0\n",
    "element vertex 4\n",
    "element vertex ",
    "element face 4\n",
    "element face ",
    "element tristrips 1\n",
    "element x 1\n",
    "property float x\n",
    "property double y\n",
    "property int z\n",
    "property float x\nproperty float y\nproperty float z\n",
    "property list uchar int vertex_indices\n",
    "property list uchar uint vertex_index\n",
    "property list int int vertex_indices\n",
    "property list uchar float a\n",
    "comment\n",
    "obj_info\n",
    "end_header\n",
    "0 0 0\n",
    "1 0 0\n",
    "0 1 0\n",
    "0 0 1\n",
    "3 0 2 1\n",
    "3 0 1 3\n",
    "3 1 2 3\n",
    "3 0 3 2\n",
    "6 0 1 2 3 0 1\n",
    "4 0 1 -1 2\n",
    "4\n",
    "1\n",
    "0\n",
    "99999999999\n",
    " ",
    "\n",
    " -1",
    " nan",
    four_bytes_of_zero,
    "\x03",
    "\x80?",
    "\xff\xff\xff\xff"};

inline const Words words_of_stl = {
    "solid\n",
    "solid a\n",
    "facet normal 0 0 1\n",
    "outer loop\n",
    "vertex 0 0 0\n",
    "vertex 1 0 0\n",
    "vertex 0 1 0\n",
    "vertex 0 0 1\n",
    "vertex",
    "endloop\n",
    "endfacet\n",
    "endsolid\n",
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n",
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\n",
    "facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\n",
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0\nendloop\nendfacet\n",
    " 0",
    " 1",
    " nan",
    " 1e300",
    "\n",
    " ",
    "FACET ",
    std::string(76, ' '),
    std::string("\4\0\0\0", 4),
    four_bytes_of_zero + four_bytes_of_zero + four_bytes_of_zero,
    std::string("\0\0\x80?", 4),
    std::string(2, '\0'),
    "\xff\xff\xff\xff"};

// A number of bytes, as VTK's files have it, and the bytes.
inline std::string sized(const std::vector<std::uint32_t>& numbers)
{
  std::vector<std::uint32_t> all = {static_cast<std::uint32_t>(4 * numbers.size())};
  all.insert(all.end(), numbers.begin(), numbers.end());
  return vfc::base64(all);
}

// The same as one compressed block.
inline std::string deflated(const std::vector<std::uint32_t>& numbers)
{
  const auto size = static_cast<uLong>(4 * numbers.size());
  std::string block(compressBound(size), '\0');
  uLongf length = block.size();
  compress(reinterpret_cast<Bytef*>(block.data()), &length,
           reinterpret_cast<const Bytef*>(numbers.data()), size);
  block.resize(length);
  const auto number = static_cast<std::uint32_t>(size);
  return vfc::base64(std::vector<std::uint32_t>{1, number, 0, static_cast<std::uint32_t>(length)}) +
         vfc::base64(block);
}

inline constexpr std::uint32_t one = 0x3f800000; // as a float
inline const std::vector<std::uint32_t> points = {0, 0, 0, one, 0, 0, 0, one, 0, 0, 0, one};
inline const std::vector<std::uint32_t> faces = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};

inline const Words words_of_vtp = {
    "<VTKFile type=\"PolyData\"><Piece><Points><DataArray>0 0 0 1 0 0 0 1 0 0 0 "
    "1</DataArray></Points>",
    "<Polys><DataArray Name=\"connectivity\">0 2 1 0 1 3 1 2 3 0 3 2</DataArray>",
    "<DataArray Name=\"offsets\">3 6 9 12</DataArray></Polys>",
    "<VTKFile type=\"PolyData\">",
    "<VTKFile type=\"PolyData\" byte_order=\"BigEndian\">",
    "<VTKFile type=\"PolyData\" header_type=\"UInt64\">",
    "<VTKFile type=\"PolyData\" compressor=\"vtkZLibDataCompressor\">",
    "<Piece>",
    "</Piece></VTKFile>",
    "<Points>",
    "</Points>",
    "<Polys>",
    "</Polys>",
    "<Strips>",
    "</Strips>",
    "<DataArray Name=\"connectivity\">",
    "<DataArray Name=\"offsets\">",
    "<DataArray type=\"Float32\" format=\"binary\">",
    "<DataArray type=\"Int32\" Name=\"connectivity\" format=\"binary\">",
    "<DataArray type=\"UInt32\" Name=\"offsets\" format=\"binary\">",
    "<DataArray type=\"Float64\" format=\"appended\" offset=\"0\"/>",
    "<DataArray type=\"UInt8\" Name=\"offsets\" format=\"appended\" offset=\"9\"/>",
    "</DataArray>",
    "<AppendedData encoding=\"raw\">_",
    "<AppendedData encoding=\"base64\">_",
    sized(points),
    sized(faces),
    sized({3, 6, 9, 12}),
    sized({4}),
    deflated(points),
    deflated(faces),
    deflated({3, 6, 9, 12}),
    vfc::base64(std::vector<std::uint32_t>{1, 4, 4, 12}),
    vfc::base64(std::vector<std::uint32_t>{3, 1u << 31, 0, 0, 0, 0}),
    four_bytes_of_zero,
    std::string("\x08\0\0\0", 4),
    "\xff\xff\xff\xff",
    "eJw",
    "=",
    "AAAA",
    "\n",
    "<!--",
    "-->",
    "<",
    ">",
    " 0",
    " 1",
    " 2",
    " 3",
    " -1",
    " nan"};

} // namespace mesh_words

#endif // VFC_TEST_WORDS_OF_MESHES_H
