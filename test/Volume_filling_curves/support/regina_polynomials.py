#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Prints Regina's polynomials of diagrams in a file, one planar diagram code per line: HOMFLY-PT in the
variables of Lickorish and Millett, and Jones in the square root of t. To be run by regina-python."""

import ast
import sys

import regina

for line in open(sys.argv[1]):
    code = [[arc + 1 for arc in crossing] for crossing in ast.literal_eval(line)]
    link = regina.Link.fromPD(code)
    print(link.homflyLM())
    print(link.jones())
