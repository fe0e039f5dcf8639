#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Has VTK read what the program vfc writes: VTP with lines and point data, the vertices of PLY (its
edges VTK passes over), the frames that a PVD file lists, and tubes. Has vfc read what VTK writes, in
every encoding."""

import itertools
import os
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

try:
    import vtk
except ImportError:
    print("there is no VTK for Python (python3-vtk9)")
    sys.exit(77)

LIMIT, INVALID_INPUT = 2, 4  # exit statuses


def vfc(*arguments, expected=0):
    command = [os.environ["VFC_PROGRAM"], *map(str, arguments)]
    result = subprocess.run(command, capture_output=True, text=True)
    assert result.returncode == expected, (arguments, result.returncode, result.stderr)


def read(reader, file):
    reader.SetFileName(str(file))
    reader.Update()
    assert reader.GetErrorCode() == 0, file
    return reader.GetOutput()


def points(data):
    return [data.GetPoint(i) for i in range(data.GetNumberOfPoints())]


def lines(data):
    ids, result = vtk.vtkIdList(), []
    data.GetLines().InitTraversal()
    while data.GetLines().GetNextCell(ids):
        result.append([ids.GetId(i) for i in range(ids.GetNumberOfIds())])
    return result


def columns(data):
    arrays = data.GetPointData()
    return {
        arrays.GetArrayName(i): [arrays.GetArray(i).GetTuple1(v) for v in range(data.GetNumberOfPoints())]
        for i in range(arrays.GetNumberOfArrays())
    }


def read_obj(file):
    """The points and polylines of an OBJ file, the latter with indices from 0."""
    words = [line.split() for line in file.read_text().splitlines()]
    return ([tuple(map(float, w[1:4])) for w in words if w[0] == "v"],
            [[int(i) - 1 for i in w[1:]] for w in words if w[0] == "l"])


def check_curves(folder):
    link, vtp, ply = folder / "link.obj", folder / "link.vtp", folder / "link.ply"
    vfc("generate", "torus-knot", "--p", 2, "--q", 4, "-o", link)
    vfc("convert", link, "-o", vtp, "--thickness", 1)
    vfc("convert", link, "-o", ply)
    expected_points, expected_lines = read_obj(link)
    data = read(vtk.vtkXMLPolyDataReader(), vtp)
    assert points(data) == expected_points, "to the last bit"
    assert lines(data) == expected_lines and len(expected_lines) == 2
    values = columns(data)
    n = len(expected_points)
    assert sorted(values) == ["component", "curvature", "origin", "radius"], sorted(values)
    assert values["origin"] == list(range(n))
    assert values["component"] == [int(v >= expected_lines[1][0]) for v in range(n)]
    assert all(0 < x < 10 for x in values["curvature"])
    assert all(0 < x <= 2 for x in values["radius"]) and len(set(values["radius"])) > 1
    for p, q in zip(points(read(vtk.vtkPLYReader(), ply)), expected_points, strict=True):
        assert all(abs(x - y) < 1e-6 for x, y in zip(p, q)), "VTK keeps single precision of PLY"


def check_pinned_nodes(folder):
    arc, vtp = folder / "arc.obj", folder / "arc.vtp"
    arc.write_text("v 0 0 0\nv 1e-310 1 0\nv 2 1e150 0.1\nl 1 2 3\nfixed 2\n")
    vfc("convert", arc, "-o", vtp)
    assert columns(read(vtk.vtkXMLPolyDataReader(), vtp))["pinned"] == [0, 1, 0]


def check_frames(folder):
    knot, film = folder / "knot.obj", folder / "film"
    vfc("generate", "torus-knot", "-o", knot)
    vfc("untangle", knot, "--max-iterations", 4, "--frames", film, "--every", 2, "--frame-format", "vtp",
        expected=LIMIT)
    root = ElementTree.parse(film / "frames.pvd").getroot()
    assert (root.tag, root.get("type")) == ("VTKFile", "Collection")
    frames = [(float(item.get("timestep")), item.get("file")) for item in root.iter("DataSet")]
    assert [time for time, _ in frames] == [0, 2, 4]
    for _, file in frames:
        assert len(lines(read(vtk.vtkXMLPolyDataReader(), film / file))) == 1, file


def check_tubes(folder):
    knot, sizes = folder / "knot.obj", []
    for reader, name in ((vtk.vtkSTLReader(), "tube.stl"), (vtk.vtkPLYReader(), "tube.ply"),
                         (vtk.vtkOBJReader(), "tube.obj")):
        vfc("convert", knot, "--tube", 0.2, "-o", folder / name)
        tube = read(reader, folder / name)
        mass = vtk.vtkMassProperties()
        mass.SetInputData(tube)
        sizes.append((tube.GetNumberOfCells(), round(mass.GetVolume(), 4)))
    assert sizes[0] == sizes[1] == sizes[2] and sizes[0][1] > 0, sizes


def encodings():
    """Writers of VTP in every encoding but LZ4 and LZMA."""
    for mode, is_base64, is_compressed, is_long, is_big in itertools.product(
            ("Ascii", "Binary", "Appended"), *[(False, True)] * 4):
        writer = vtk.vtkXMLPolyDataWriter()
        getattr(writer, f"SetDataModeTo{mode}")()
        writer.SetEncodeAppendedData(is_base64)
        (writer.SetCompressorTypeToZLib if is_compressed else writer.SetCompressorTypeToNone)()
        (writer.SetHeaderTypeToUInt64 if is_long else writer.SetHeaderTypeToUInt32)()
        (writer.SetByteOrderToBigEndian if is_big else writer.SetByteOrderToLittleEndian)()
        writer.SetBlockSize(4096)
        yield writer, (mode, is_base64, is_compressed, is_long, is_big)


def written(writer, data, file):
    writer.SetInputData(data)
    writer.SetFileName(str(file))
    assert writer.Write() == 1
    return file


def stripped(data):
    stripper = vtk.vtkStripper()
    stripper.SetInputData(data)
    stripper.Update()
    assert stripper.GetOutput().GetNumberOfStrips() > 0
    return stripper.GetOutput()


def check_encodings(folder):
    knot, file, again = folder / "binary.obj", folder / "binary.vtp", folder / "again.obj"
    vfc("generate", "torus-knot", "--nodes", 300, "-o", knot)
    vfc("convert", knot, "-o", file)
    curve = read(vtk.vtkXMLPolyDataReader(), file)
    source = vtk.vtkSphereSource()
    source.SetThetaResolution(40)
    source.SetPhiResolution(40)
    source.Update()
    for writer, encoding in encodings():
        vfc("convert", written(writer, curve, file), "-o", again, "--force")
        assert read_obj(again) == read_obj(knot), encoding
    surfaces = set()
    for writer, encoding in encodings():
        for data in (source.GetOutput(), stripped(source.GetOutput())):
            vfc("convert", written(writer, data, file), "-o", folder / "sphere.off", "--force")
            vfc("check", file)
            surfaces.add((data.GetNumberOfStrips() > 0, (folder / "sphere.off").read_text()))
    assert len(surfaces) == 2, "the same in every encoding"
    for compressor in ("LZ4", "LZMA"):
        writer = vtk.vtkXMLPolyDataWriter()
        getattr(writer, f"SetCompressorTypeTo{compressor}")()
        vfc("check", written(writer, curve, file), expected=INVALID_INPUT)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        for check in (check_curves, check_pinned_nodes, check_frames, check_tubes, check_encodings):
            check(pathlib.Path(name))
            print(check.__name__, "passed")
