# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Certified untangling of knots, and filling of volumes with curves.

A curve is an array of shape (n, 3); several are a list of such arrays. Curves are closed unless
`closed` says otherwise, and need not repeat their first point. A `Network` has junctions. Meshes are
vertices of shape (n, 3) and faces of shape (m, 3). Lengths are in the unit of the input.

No strand ever passes through another one: every change of a curve is certified with exact
predicates. The same input gives the same bits, whatever the number of threads.
"""

from ._results import (ArcConflict, ArcPath, ArcPieces, ArcSpline, Coverage, CurveMeasures,
                       EmptyRegion, FillingResult, FlowStatistics, LinkIdentity, PlanarDiagram,
                       PortNeck, ShapeExcess, ThicknessFit, UntanglingResult, Verdict)
from ._vfc import Interrupted
from .curves import Network
from .domains import Ball, Box, Domain, Implicit, Mesh, Polygons
from .files import read, write
from .generators import closed_braid, hard_unknot, random_polygon, torus_knot
from .measures import arc_spline, coverage, identify, length, measure, outside, tube
from .meshes import MeshDefect, RepairedMesh, check_mesh, repair
from .runs import Filled, Simplified, Untangled, fill, simplify, untangle, verify
