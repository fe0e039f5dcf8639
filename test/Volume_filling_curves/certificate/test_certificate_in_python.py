#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Verifies certificates with nothing but the page "Format of Certificates" of the manual: by brute
force, in rational arithmetic, without any code of the package. Shows that the page says all that is
needed, and that `vfc untangle --certificate` and `vfc check --certificate` mean the same."""

import hashlib
import math
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
from fractions import Fraction

LIMIT, INVALID = 2, 4  # exit statuses of the program


class Rejected(Exception):
    pass


def require(condition, why):
    if not condition:
        raise Rejected(why)


# Vectors of rational numbers


def exact(p):
    return tuple(map(Fraction, p))


def sub(u, v):
    return (u[0] - v[0], u[1] - v[1], u[2] - v[2])


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u, v):
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def interval(p, q, conditions):
    """The times t in [0, 1] when p + t (q - p) fulfils f = 0 or f >= 0 for all conditions; None if
    there are none."""
    lower, upper = Fraction(0), Fraction(1)
    for f, is_equation in conditions:
        for sign in (1, -1) if is_equation else (1,):
            start, change = sign * f(p), sign * (f(q) - f(p))
            if change > 0:
                lower = max(lower, -start / change)
            elif change < 0:
                upper = min(upper, -start / change)
            elif start < 0:
                return None
    return (lower, upper) if lower <= upper else None


def on_line(a, direction):
    return [(lambda x, k=k: cross(sub(x, a), direction)[k], True) for k in range(3)]


def in_triangle(corners):
    a, b, c = corners
    normal = cross(sub(b, a), sub(c, a))
    if any(normal):
        sides = [(corners[k], cross(normal, sub(corners[(k + 1) % 3], corners[k]))) for k in range(3)]
        return [(lambda x: dot(sub(x, a), normal), True)] + [
            (lambda x, u=u, n=n: dot(sub(x, u), n), False) for u, n in sides]
    u, v = min(corners), max(corners)
    direction = sub(v, u)
    if not any(direction):
        return [(lambda x, k=k: x[k] - u[k], True) for k in range(3)]
    return on_line(u, direction) + [(lambda x: dot(sub(x, u), direction), False),
                                    (lambda x: dot(sub(v, x), direction), False)]


def boxes_meet(points1, points2):
    return all(
        min(p[k] for p in points1) <= max(p[k] for p in points2)
        and min(p[k] for p in points2) <= max(p[k] for p in points1) for k in range(3))


class Curve:
    """Nodes under their numbers, edges as pairs."""

    def __init__(self, points, edges):
        self.points = dict(enumerate(points))
        self.edges = set(map(frozenset, edges))
        self.next_number = len(points)

    def neighbors(self, v):
        return [w for e in self.edges if v in e for w in e if w != v]

    def require_free(self, corners, shared, taken_out):
        """The triangle meets the edges that stay only in the corners that are shared."""
        triangle = [exact(p) for p in corners]
        for edge in self.edges - taken_out:
            ends = [self.points[v] for v in edge]
            if not boxes_meet(ends, corners):
                continue
            allowed = [v for v in edge if v in shared]
            require(len(allowed) < 2, f"edge {set(edge)} is in the way")
            p, q = map(exact, ends)
            times = interval(p, q, in_triangle(triangle))
            if times and allowed:  # the common node and nothing else
                common = 0 if tuple(edge)[0] == allowed[0] else 1
                times = None if times == (common, common) else times
            require(times is None, f"edge {set(edge)} is in the way")

    def require_passage(self, b, target, a, c):
        """b may meet the line ac only strictly between a and c."""
        p, q, a, c = map(exact, (b, target, a, c))
        direction = sub(c, a)
        times = interval(p, q, on_line(a, direction))
        for t in times or ():
            x = tuple(p[k] + t * (q[k] - p[k]) for k in range(3))
            require(0 < dot(sub(x, a), direction) < dot(direction, direction), "passes a neighbor")

    def require_corner_move(self, a, b, c, taken_out):
        pa, pc = self.points[a], self.points[c]
        if any(cross(sub(exact(b), exact(pa)), sub(exact(pc), exact(pa)))):
            self.require_free((pa, b, pc), {a, c}, taken_out)
        else:
            self.require_passage(b, b, pa, pc)

    def require_node(self, v):
        require(v in self.points, f"there is no node {v}")

    def move(self, v, target):
        self.require_node(v)
        b, around = self.points[v], self.neighbors(v)
        if b == target:
            return
        for i, a in enumerate(around):
            on_way = interval(exact(b), exact(target), in_triangle([exact(self.points[a])] * 3))
            require(on_way is None, "runs over a neighbor")
            for c in around[:i]:
                self.require_passage(b, target, self.points[a], self.points[c])
            self.require_free((self.points[a], b, target), {a}, {e for e in self.edges if v in e})
        self.points[v] = target

    def insert(self, a, c, b):
        edge = frozenset((a, c))
        require(edge in self.edges, "there is no such edge")
        self.require_corner_move(a, b, c, {edge})
        v, self.next_number = self.next_number, self.next_number + 1
        self.points[v] = b
        self.edges = self.edges - {edge} | {frozenset((a, v)), frozenset((v, c))}

    def remove(self, v):
        self.require_node(v)
        around = self.neighbors(v)
        require(len(around) == 2, "the node does not have two neighbors")
        edge, old = frozenset(around), {e for e in self.edges if v in e}
        require(edge not in self.edges, "the edge is there already")
        self.require_corner_move(around[0], self.points[v], around[1], old)
        self.edges = self.edges - old | {edge}
        del self.points[v]

    def canonical(self):
        used = sorted(set().union(*self.edges), key=lambda v: self.points[v])
        rank = {v: i for i, v in enumerate(used)}
        points = [tuple(x + 0. for x in self.points[v]) for v in used]
        return points, sorted(tuple(sorted(rank[v] for v in e)) for e in self.edges)

    def digest(self):
        points, edges = self.canonical()
        data = struct.pack("<QQ", len(points), len(edges))
        data += b"".join(struct.pack("<ddd", *p) for p in points)
        data += b"".join(struct.pack("<QQ", *e) for e in edges)
        return hashlib.sha256(data).digest()


def read_obj(path):
    points, edges = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words and words[0] == "v":
            points.append(tuple(map(float, words[1:4])))
        if words and words[0] == "l":
            nodes = [int(word) - 1 for word in words[1:]]
            edges += zip(nodes, nodes[1:])
    return Curve(points, edges)


class Reader:
    def __init__(self, data):
        self.data, self.place = data, 0

    def take(self, form):
        size = struct.calcsize("<" + form)
        require(self.place + size <= len(self.data), "ends too early")
        self.place += size
        return struct.unpack("<" + form, self.data[self.place - size:self.place])

    def position(self):
        p = self.take("ddd")
        require(all(map(math.isfinite, p)), "a position is not finite")
        return p

    def varint(self):
        x, shift = 0, 0
        while True:
            byte, = self.take("B")
            require(byte or not shift, "a varint with too many bytes")
            x |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return x


def signed(m):
    return m // 2 if m % 2 == 0 else -(m + 1) // 2


def verify(data, start, end):
    """Returns the number of operations. Throws Rejected."""
    require(data[-32:] == hashlib.sha256(data[:-32]).digest(), "altered")
    reader = Reader(data)
    magic, version, nodes, edges, _, digest = reader.take("8sIQQQ32s")
    require((magic, version) == (b"VFC-CERT", 2), "no certificate")
    require(digest == start.digest(), "another start")
    curve = Curve(*start.canonical())
    require((nodes, edges) == (len(curve.points), len(curve.edges)), "other numbers at the start")
    before, count = 0, 0
    while True:
        word = reader.varint()
        kind, m = word & 3, word >> 2
        if kind == 3:
            require(m == 0, "an unknown operation")
            break
        count += 1
        before += signed(m)
        if kind == 0:
            curve.move(before, reader.position())
        elif kind == 1:
            curve.insert(before, before + signed(reader.varint()), reader.position())
        else:
            curve.remove(before)
    operations, nodes, edges, digest = reader.take("QQQ32s")
    require((operations, nodes, edges) == (count, len(curve.points), len(curve.edges)), "miscounted")
    require(digest == curve.digest() == end.digest(), "another end")
    reader.take("32s")
    require(reader.place == len(data), "bytes behind the end")
    return count


def is_rejected(data, start, end):
    try:
        verify(data, start, end)
    except Rejected:
        return True
    return False


def run(*arguments, expected=(0,)):
    program = os.environ["VFC_PROGRAM"]
    result = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    assert result.returncode in expected, (arguments, result.returncode, result.stderr)
    return result.returncode


def test(folder):
    start, end, cert = folder / "start.obj", folder / "end.obj", folder / "run.cert"
    run("generate", "braid", "--word", "1 1 1", "--nodes", 36, "-o", start)
    run("untangle", start, "-o", end, "--certificate", cert, "--strategy", "flow",
        "--max-iterations", 2, "--quiet", expected=(0, LIMIT))
    run("check", "--certificate", cert, start, end)
    run("check", "--certificate", cert, start, start, expected=(INVALID,))
    curves, data = (read_obj(start), read_obj(end)), cert.read_bytes()
    print(verify(data, *curves), "operations verified")
    assert is_rejected(data, curves[1], curves[0])

    def altered(place):
        return data[:place] + bytes([data[place] ^ 64]) + data[place + 1:]

    for place in range(0, len(data), 7):
        assert is_rejected(altered(place), *curves), place
    # With a hash that fits it depends, but all agree. Nonsense is a number that is not finite, and an
    # operation that there is not, wherever they happen to stand.
    places = range(90, len(data) - 100, len(data) // 6)
    nonsense = struct.pack("<d", math.nan)[-2:], b"\x07"
    forgeries = [altered(place) for place in places]
    forgeries += [data[:place] + b + data[place + len(b):] for place in places for b in nonsense]
    for place, forgery in enumerate(forgeries):
        forged = forgery[:-32]
        cert.write_bytes(forged + hashlib.sha256(forged).digest())
        status = run("check", "--certificate", cert, start, end, expected=(0, INVALID))
        assert is_rejected(cert.read_bytes(), *curves) == (status == INVALID), place


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        test(pathlib.Path(name))
