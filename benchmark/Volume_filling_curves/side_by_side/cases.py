# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""What programs are run on."""

import dataclasses
import pathlib
import subprocess

CUBE_POINTS = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
CUBE_FACES = [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3),
              (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5)]


@dataclasses.dataclass(frozen=True)
class Case:
    """A run that is to be measured. Cases of a series have a size, by which the next one's time is
    foreseen; those of a group are added up in tables."""
    suite: str
    name: str
    job: str  # fill, untangle or simplify
    input: pathlib.Path
    thickness: float = None
    options: tuple = ()
    series: str = ""
    size: float = 0
    group: str = ""
    threads: int = 0  # 0: as in all other runs
    for_others: bool = True  # than the build that is measured

    def words(self):
        """What is asked of vfc."""
        r = ["--thickness", self.thickness] if self.thickness else []
        return [self.job, self.input, *r, *self.options]


class Inputs:
    """Curves and meshes: the project's own, those of the shared data, and those made here."""

    def __init__(self, package, shared, folder, vfc):
        self.bundled, self.shared, self.folder, self.vfc = package / "data", shared, folder, vfc
        self.missing = []

    def of_shared_data(self, path):
        """None if it is not there, which is noted."""
        file = self.shared / path
        if file.exists():
            return file
        self.missing.append(path)
        return None

    def all_of_shared_data(self, folder):
        files = sorted((self.shared / folder).glob("*.obj"))
        if not files:
            self.missing.append(folder)
        return files

    def cube(self):
        points = [f"{x} {y} {z}" for x, y, z in CUBE_POINTS]
        faces = [f"3 {a} {b} {c}" for a, b, c in CUBE_FACES]
        file = self.folder / "cube.off"
        file.write_text("\n".join(["OFF", f"{len(points)} {len(faces)} 0", *points, *faces, ""]))
        return file

    def made(self, name, *words):
        """A file that vfc writes once."""
        file = self.folder / name
        if not file.exists():
            command = [*self.vfc.words, *map(str, words), "-o", str(file), "--quiet"]
            subprocess.run(command, check=True)
        return file

    def mended(self, mesh):
        return self.made(f"{mesh.name}.off", "repair", mesh)

    def random_polygon(self, nodes):
        return self.made(f"polygon_{nodes}.obj", "generate", "random-polygon", "--nodes", nodes, "--seed", 1)

    def simplified_polygon(self, nodes):
        return self.made(f"simplified_{nodes}.obj", "simplify", self.random_polygon(nodes), "--threads", 1)

    def torus_knot(self, p, q):
        return self.made(f"torus_knot_{p}_{q}.obj", "generate", "torus-knot", "--p", p, "--q", q)
