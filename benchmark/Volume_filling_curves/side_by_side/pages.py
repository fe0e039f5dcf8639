# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Pages that tables are put into: one of all tables, and those of the project, which have places for
some of them, between the lines <!-- benchmark NAME --> and <!-- end of benchmark -->."""

import re

from .tables import tables

PLACE = re.compile(r"(<!-- benchmark ([^>]+) -->\n).*?(<!-- end of benchmark -->)", re.DOTALL)


def about(lines):
    """Programs, machines and dates."""
    programs = {f"* {line['program']}: {line['versions']}, file {line['digest']}" for line in lines}
    machines = {f"* {line['machine']}, {line['processors']} processors" for line in lines}
    dates = sorted(line["date"] for line in lines)
    return "\n".join([*sorted(programs), *sorted(machines), f"* {dates[0]} to {dates[-1]}, {len(lines)} runs"])


def page(lines):
    """Everything."""
    parts = [about(lines), *(f"## {name}\n\n{text}" for name, text in tables(lines).items())]
    return "\n\n".join(parts) + "\n"


def put_into(file, lines):
    """Renews the tables of a page; those of "own ..." have no rows of other programs. Returns the names
    for which nothing was measured."""
    own = [line for line in lines if line["program"] == lines[0]["program"]]
    named = {**tables(lines), **{f"own {name}": text for name, text in tables(own).items()}}
    missing = []

    def renewed(match):
        start, name, end = match.groups()
        if name in named:
            return f"{start}\n{named[name]}\n\n{end}"
        missing.append(name)
        return match.group(0)

    file.write_text(PLACE.sub(renewed, file.read_text()))
    return missing
