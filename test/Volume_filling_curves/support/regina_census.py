#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Prints the prime knots of up to 10 crossings in Regina's census: the number of crossings, then the arcs of its
planar diagram code, from 0 on. To be run by regina-python."""

import pathlib

import regina

census = regina.open(str(pathlib.Path(regina.GlobalDirs.examples()) / "knot-census.rga"))
for packet in census.descendants():
    if isinstance(packet, regina.Link) and 0 < packet.size() <= 10:
        print(packet.size(), *(arc - 1 for crossing in packet.pdData() for arc in crossing))
