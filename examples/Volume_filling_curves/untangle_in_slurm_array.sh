#!/usr/bin/env bash
#SBATCH --array=1-4
#SBATCH --cpus-per-task=1
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
#
# Untangles the curves that knots.txt lists, in four tasks of Slurm: sbatch untangle_in_slurm_array.sh
# If submitted again, after a failure or a time limit, it continues.

vfc untangle --batch knots.txt -o untangled --shard "$SLURM_ARRAY_TASK_ID/4" \
  --threads "$SLURM_CPUS_PER_TASK" --quiet
