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

from ._results import (ArcConflict, ArcPath, ArcPieces, ArcSpline, ChainIdentity, ChainSections,
                       ClosureKnot, Coverage, CurveMeasures, EmptyRegion, FillingResult,
                       FlowStatistics, KnotShare, LinkIdentity, PlanarDiagram, PortNeck, ShapeExcess,
                       ThicknessFit, UntanglingResult, Verdict)
from ._vfc import Interrupted, __version__
from .checks import WallDistance, check_curves, outside, wall_distance
from .curves import Network
from .defects import CurveDefect, MeshDefect
from .domains import Ball, Box, Domain, Implicit, Mesh, Polygons
from .files import read, write
from .generators import closed_braid, hard_unknot, random_polygon, torus_knot
from .identification import identify, identify_chain
from .measures import arc_spline, coverage, length, measure, tube
from .meshes import RepairedMesh, check_mesh, repair
from .runs import Filled, Simplified, Untangled, fill, simplify, untangle, verify
