#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# Untangles the curves that knots.txt lists, in four processes of GNU parallel. If started again, it
# continues.

parallel vfc untangle --batch knots.txt -o untangled --shard {}/4 --threads 1 --quiet ::: 1 2 3 4
