#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""The filter through which Doxygen reads headers. In place of \\vfcNamedParams{SIGNATURE} functions
get the table of the named parameters of that signature, in CGAL's form. The names come from the
tables in the code, all else from the members that they set. A named parameter that sets no member
is described by hand, once.

named_parameters.py HEADER"""

import pathlib
import re
import sys
from functools import cache

INCLUDE = pathlib.Path(__file__).resolve().parents[2] / "include/CGAL/Volume_filling_curves"
COMMAND = r"\\vfcNamedParams\{(\w+)\}"
SEQUENCE = "an optional sequence of named parameters among the ones listed below"
STRUCT = "the parameters, whose members are listed below"
RANGES = {"POSITIVE": "positive and finite", "UP_TO_ONE": "positive and at most 1",
          "UP_TO_A_MILLION": "positive and at most 1,000,000",
          "NOT_NEGATIVE": "finite and not negative", "NOT_NEGATIVE_OR_NEVER": "not negative"}
UNITS = r"in units of|in the input's unit|in seconds|dimensionless"
DEFAULTS = {"std::numeric_limits<double>::infinity()": "infinity", "nullptr": "none", "": "none"}


@cache
def sources():
    return "\n".join(file.read_text() for file in sorted(INCLUDE.rglob("*.h")))


@cache
def struct(name):
    """The base of a struct, its documented members, and the defaults of the base that it changes."""
    base, body = re.search(rf"struct {name}(?: : (\w+))?\n{{\n(.*?)\n}};", sources(), re.S).groups()
    members = re.findall(r"((?:  ///.*\n)+)  ([^;{}]*?) ?(\w+)(?: = ([^;]*))?;", body)
    changed = re.findall(rf"\b{name}\(\)\s*{{([^}}]*)}}", body)
    return base, {member[2]: member for member in members}, dict(re.findall(r"(\w+) = ([^;]+);", "".join(changed)))


def described(name, member):
    """The comment, the type and the default of a member of a struct or of its bases."""
    base, members, changed = struct(name)
    comment, kind, _, default = members[member] if member in members else described(base, member)
    return comment, kind, member, changed.get(member, default)


@cache
def rows(name):
    """Each parameter of a struct: the name, the members that it sets, and their range."""
    table = re.search(rf"parameter_table\(const {name}\b.*?\n}}", sources(), re.S)[0]
    own = re.findall(r"parameter<(?:\w+::)?(\w+)_t>\(\s*&\w+::(\w+)(?:, Range::(\w+))?\)", table)
    undocumented = set(struct(name)[1]) ^ {member for _, member, _ in own}
    if undocumented:
        raise SystemExit(f"{name}: no row in the table or no comment: {', '.join(undocumented)}")
    base = struct(name)[0]
    return own + (rows(base) if base else [])


@cache
def by_hand(name, lists):
    """The lines that describe a named parameter that sets no member: those before one of the lists of
    tags, or else those before no list."""
    found = re.findall(rf"(\\cgalParamNBegin{{{name}}}.*?\\cgalParamNEnd)(?:\nusing (\w+))?", sources(), re.S)
    blocks = ([block for block, owner in found if owner in lists] or
              [block for block, owner in found if not owner])
    if len(blocks) != 1:
        raise SystemExit(f"{name} is described {len(blocks)} times by hand, and sets no member")
    return [re.sub(r"^\s*(//|\*) *", "", line) for line in blocks[0].splitlines()]


def from_members(name, owner, settings):
    """Likewise, of a parameter that sets one or more members of a struct."""
    settings.sort(key=lambda setting: setting[0] != name)
    comments, kinds, _, defaults = zip(*(described(owner, member) for member, _ in settings))
    text, *others = (" ".join(re.findall(r"/// ?(.*)", comment)) for comment in comments)
    for other in others:
        text += " Or: " + other[0].lower() + re.sub(r" [^.]*by default\.", "", other[1:])
    kind = ", or ".join(f"`{kind.replace('internal::Field_vector', 'Vector_3')}`" for kind in kinds)
    default = DEFAULTS.get(defaults[0]) or f"`{defaults[0]}`"
    ranges = [RANGES[limits] for _, limits in settings if limits]
    if "double" in kinds and not re.search(UNITS, text):
        raise SystemExit(f"{name} of {owner} has no unit")
    return [rf"\cgalParamNBegin{{{name}}}", rf"\cgalParamDescription{{{text}}}",
            rf"\cgalParamType{{{kind}}}", rf"\cgalParamDefault{{{default}}}",
            *(rf"\cgalParamPrecondition{{{limits}}}" for limits in ranges), r"\cgalParamNEnd"]


def definition(name):
    """A list of tags, which has a name, or else nothing."""
    return "".join(re.findall(rf"using {name} =\s*(\w+<[^>]*>);", sources()))


def tags(kind, lists):
    return [tag for found in re.findall(rf"{kind}<(.*?)>", lists, re.S)
            for tag in re.findall(r"(\w+)_t\b", found)]


def entries(signature):
    """The lines of each parameter of a signature, or of a struct, by name."""
    found = re.search(rf"using {signature} =\s*Signature<(\w+)(?:<Point_3>)?(.*?)>;", sources(), re.S)
    owner, others = found.groups() if found else (signature, "")
    names = tuple(re.findall(r"\w+", others))
    lists = "".join(definition(name) for name in names)
    unused = tags(r"Without", lists)
    settings = {}
    for name, member, limits in rows(owner):
        if name not in unused:
            settings.setdefault(name, []).append((member, limits))
    return {name: from_members(name, owner, members) for name, members in settings.items()} | {
        name: by_hand(name, names) for name in tags(r"Tag_list", lists)}


def is_signature(name):
    return name.endswith("_signature")


def table(signature):
    title = "" if is_signature(signature) else rf"{{Members of `{signature}`}}"
    lines = [line for lines in entries(signature).values() for line in lines]
    return [rf"\cgalNamedParamsBegin{title}", *lines, r"\cgalNamedParamsEnd"]


def filtered(text):
    """The header, with the tables after the paragraphs that ask for them."""
    waiting = []
    for line in text.splitlines():
        if asked := re.search(COMMAND, line):
            waiting = table(asked[1])
            line = re.sub(COMMAND, SEQUENCE if is_signature(asked[1]) else STRUCT, line)
        elif waiting and re.fullmatch(r" *\*/?", line):
            indent = line[:line.index("*")]
            yield from (f"{indent}* {added}".rstrip() for added in ["", *waiting])
            waiting = []
        yield line


def functions():
    """Each function with a table: its name, the signature, and the signatures in its code."""
    for signature, after in re.findall(rf"{COMMAND}(.*?)(?=/\*!|\Z)", sources(), re.S):
        code = after.partition("*/")[2]
        yield re.search(r"(\w+)\(", code)[1], signature, set(re.findall(r"internal::(\w+_signature)", code))


if __name__ == "__main__":
    print("\n".join(filtered(pathlib.Path(sys.argv[1]).read_text())))
