#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Writes VTP files in every encoding that ParaView has, with a curve and with a surface in strips
and polygons, and has vfc read them; damages them, and has vfc refuse them with their line, within
little memory."""

import base64
import functools
import itertools
import os
import pathlib
import resource
import struct
import subprocess
import tempfile
import zlib

INVALID_INPUT = 4  # exit status
FORMATS = {"Int8": "b", "UInt8": "B", "Int32": "i", "UInt32": "I", "Int64": "q", "UInt64": "Q",
           "Float32": "f", "Float64": "d"}
ENCODINGS = ("ascii", "binary", "appended base64", "appended raw")
ZLIB = "vtkZLibDataCompressor"

CURVE_POINTS = [0, 0, 0, 1, 0, 1 / 3, 1, 1e-30, 0, 0, 1, -0.7]
CURVE = {
    "PointData": [("pinned", "UInt8", [0, 1, 0, 0])],
    "Points": [("Points", "Float64", CURVE_POINTS)],
    "Lines": [("connectivity", "Int64", [0, 1, 2, 3, 0]), ("offsets", "Int32", [5])],
}
# a cube: a strip around it, and two polygons
CUBE = {
    "Points": [("Points", "Float32", [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0,
                                      0, 1, 1, 1, 1, 1, 0, 0, 1, 1, 0, 1])],
    "Strips": [("connectivity", "UInt32", [1, 0, 3, 2, 5, 4, 7, 6, 1, 0]), ("offsets", "UInt8", [10])],
    "Polys": [("connectivity", "Int8", [0, 6, 4, 2, 1, 3, 5, 7]), ("offsets", "Int64", [4, 8])],
}


class Writer:
    """Writes a VTP file as vtkXMLPolyDataWriter does."""

    def __init__(self, encoding, compressor="", size_type="UInt32", order="<", block=16,
                 change=lambda sizes, data: (sizes, data)):
        self.encoding, self.compressor, self.order, self.block = encoding, compressor, order, block
        self.size_type, self.change, self.appended = size_type, change, b""

    def encoded(self, parts):
        return b"".join(parts) if "raw" in self.encoding else b"".join(map(base64.b64encode, parts))

    def bytes_of(self, values, number_type):
        data = struct.pack(f"{self.order}{len(values)}{FORMATS[number_type]}", *values)
        if not self.compressor:
            sizes, data = self.change([len(data)], data)
            return self.encoded([self.pack(sizes) + data])
        plain = [data[i:i + self.block] for i in range(0, len(data), self.block)]
        blocks = list(map(zlib.compress, plain))
        last = len(plain[-1]) if len(plain[-1]) < self.block else 0
        sizes, data = self.change([len(blocks), self.block, last, *map(len, blocks)], b"".join(blocks))
        return self.encoded([self.pack(sizes), data])

    def pack(self, sizes):
        return struct.pack(f"{self.order}{len(sizes)}{FORMATS[self.size_type]}", *sizes)

    def array(self, name, number_type, values):
        tag = f'<DataArray type="{number_type}" Name="{name}" format="{self.encoding.split()[0]}"'
        if self.encoding == "ascii":
            return f"{tag}>\n{' '.join(map(repr, values))}\n</DataArray>\n".encode()
        data = self.bytes_of(values, number_type)
        if self.encoding == "binary":
            return f"{tag}>\n  ".encode() + data + b"\n</DataArray>\n"
        tag = f'{tag} offset="{len(self.appended)}">\n<InformationKey name="RANGE">\n'
        self.appended += data
        return (tag + '<Value index="0">\n0.5\n</Value>\n</InformationKey>\n</DataArray>\n').encode()

    def text(self, sections):
        order = "LittleEndian" if self.order == "<" else "BigEndian"
        piece = b"".join(
            f"<{name}>\n".encode() + b"".join(itertools.starmap(self.array, arrays)) + f"</{name}>\n".encode()
            for name, arrays in sections.items())
        appended = b""
        if self.appended:
            encoding = self.encoding.split()[1]
            appended = f'<AppendedData encoding="{encoding}">\n _'.encode() + self.appended
            appended += b"\n</AppendedData>\n"
        return (f'<?xml version="1.0"?>\n<VTKFile type="PolyData" byte_order="{order}" '
                f'header_type="{self.size_type}" compressor="{self.compressor}">\n<PolyData>\n'
                f'<Piece NumberOfPoints="4" NumberOfLines="{int("Lines" in sections)}" '
                f'NumberOfPolys="{int("Polys" in sections)}">\n').encode() + piece + \
            b"</Piece>\n</PolyData>\n" + appended + b"</VTKFile>\n"


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (1 << 30, 1 << 30))


def vfc(folder, *arguments):
    return subprocess.run([os.environ["VFC_PROGRAM"], *arguments], cwd=folder, capture_output=True,
                          text=True, preexec_fn=limit_memory if starts_in_limited_memory() else None)


@functools.cache
def starts_in_limited_memory():
    """Not with AddressSanitizer, whose shadow memory takes terabytes of addresses."""
    return subprocess.run([os.environ["VFC_PROGRAM"], "--version"], capture_output=True,
                          preexec_fn=limit_memory).returncode == 0


def expect_read(folder, text, message):
    (folder / "a.vtp").write_bytes(text)
    result = vfc(folder, "convert", "a.vtp", "-o", "out.obj", "--force")
    assert result.returncode == 0, (message, result.stderr)
    return (folder / "out.obj").read_text()


def writers():
    yield Writer("ascii")
    for encoding, compressor, size_type, order in itertools.product(
            ENCODINGS[1:], ("", ZLIB), ("UInt32", "UInt64"), "<>"):
        yield Writer(encoding, compressor, size_type, order)


def check_every_encoding_is_read(folder):
    curves = {expect_read(folder, writer.text(CURVE), vars(writer)) for writer in writers()}
    cubes = {expect_read(folder, writer.text(CUBE), vars(writer)) for writer in writers()}
    assert len(curves) == len(cubes) == 1, "the same in every encoding, to the last bit"
    lines = [line.split() for line in curves.pop().splitlines()]
    assert [float(x) for w in lines if w[0] == "v" for x in w[1:4]] == CURVE_POINTS
    assert ["l", "1", "2", "3", "4", "1"] in lines and ["fixed", "2"] in lines
    assert sum(line.startswith("f ") for line in cubes.pop().splitlines()) == 12
    result = vfc(folder, "check", "a.vtp")
    assert result.returncode == 0, result.stdout + result.stderr
    result = vfc(folder, "repair", "a.vtp", "-o", "cube.off")
    assert "nothing to repair" in result.stderr, result.stderr


def check_blocks_of_any_size(folder):
    """Blocks that are all full have no last one; empty arrays have none at all."""
    whole = {**CURVE, "Verts": [("connectivity", "Int64", [])]}
    for encoding in ENCODINGS[1:]:
        for block in (8, 32, 96):
            expect_read(folder, Writer(encoding, ZLIB, block=block).text(CURVE), (encoding, block))
        expect_read(folder, Writer(encoding).text(whole), encoding)


def expect_refused(folder, text, part):
    (folder / "a.vtp").write_bytes(text)
    for command in ("check", "measure"):
        result = vfc(folder, command, "a.vtp")
        message = result.stdout + result.stderr
        assert result.returncode == INVALID_INPUT, (command, part, result.returncode, message)
        assert part in message, (part, message)


def check_other_compressors_are_named(folder):
    for name in ("vtkLZ4DataCompressor", "vtkLZMADataCompressor"):
        for sections in (CURVE, CUBE):
            expect_refused(folder, Writer("binary", name).text(sections),
                           f"a.vtp:2: error: binary data: compressed by '{name}', which is not read; "
                           "save without compression")


def check_forged_sizes_cost_nothing(folder):
    huge = {"UInt32": (2**31, 2**32 - 1), "UInt64": (2**31, 2**62, 2**64 - 1, 2**64 - 8)}
    for encoding, compressor, sections in itertools.product(ENCODINGS[1:], ("", ZLIB), (CURVE, CUBE)):
        for size_type, sizes in huge.items():
            for size, place in itertools.product(sizes, range(4 if compressor else 1)):
                def forge(old, data, size=size, place=place):
                    return old[:place] + [size] + old[place + 1:], data

                writer = Writer(encoding, compressor, size_type, change=forge)
                expect_refused(folder, writer.text(sections), "error: binary data: ")


def check_bombs_are_refused(folder):
    zeros = [("Points", "Float64", [0.] * 6000000)]
    writer = Writer("binary", ZLIB, block=1 << 24)
    expect_refused(folder, writer.text({**CURVE, "Points": zeros}), "not expected to hold")


def check_damage_is_refused(folder):
    text = Writer("binary").text(CURVE)
    start = text.index(b'Name="Points"')
    place = text.index(b">", start) + 10
    line = text[:place].count(b"\n")
    for wrong in b"=", b"*", b"\xff", b"<!---->":
        damaged = text[:place] + wrong + text[place + 1:]
        expect_refused(folder, damaged, f"a.vtp:{line}: error: binary data: an array")
    for damage in (lambda s, d: (s, d[:-1]), lambda s, d: (s, d[:4] + b"?" + d[5:])):
        for encoding in ENCODINGS[1:]:
            writer = Writer(encoding, ZLIB, change=damage)
            expect_refused(folder, writer.text(CURVE), "error: binary data: ")
    text = Writer("appended raw").text(CURVE)
    for old, new, part in ((b'offset="108"', b'offset="99999"', "not where its offset"),
                           (b' _', b' ', "do not begin with '_'"),
                           (b'"Float64"', b'"Float16"', "'Float16' is no type"),
                           (b'"UInt32"', b'"UInt24"', "UInt32 or UInt64, not 'UInt24'")):
        assert old in text, old
        expect_refused(folder, text.replace(old, new), part)
    for end in range(0, text.index(b"\n</AppendedData>"), 7):
        (folder / "cut.vtp").write_bytes(text[:end])
        assert vfc(folder, "check", "cut.vtp").returncode == INVALID_INPUT, end


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        for check in (check_every_encoding_is_read, check_blocks_of_any_size,
                      check_other_compressors_are_named, check_forged_sizes_cost_nothing,
                      check_bombs_are_refused, check_damage_is_refused):
            check(pathlib.Path(name))
            print(check.__name__, "passed")
