# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""What the headers say of structs, their members and enumerations, in words of Python's users."""

import pathlib
import re
import sys
from functools import cache

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "doc/Volume_filling_curves"))
import named_parameters  # noqa: E402

RESULTS = {  # struct in C++: class in Python
    "Curve_flow_statistics": "FlowStatistics", "Untangling_result": "UntanglingResult",
    "Thickness_fit": "ThicknessFit", "Coverage": "Coverage", "Empty_region_3": "EmptyRegion",
    "Shape_excess_3": "ShapeExcess", "Port_neck": "PortNeck", "Filling_result": "FillingResult",
    "Curve_measures": "CurveMeasures",
    "Certificate_verdict": "Verdict", "Arc_conflict": "ArcConflict", "Arc_spline_piece": "ArcPieces",
    "Arc_spline_path": "ArcPath", "Arc_spline": "ArcSpline", "Planar_diagram": "PlanarDiagram",
    "Link_identity": "LinkIdentity",
    "Knot_share": "KnotShare", "Closure_knot": "ClosureKnot", "Chain_section": "ChainSections",
    "Chain_identity": "ChainIdentity"}
OPTIONS = {"untangle": "Untangle_signature", "fill": "Fill_signature", "simplify": "Simplify_signature",
           "identify_chain": "Chain_signature"}
MEASURES = "Curve_measures"  # whose members are described at the functions of the same names
IN_PYTHON = {  # what the headers say of C++: what Python's users need
    " if the `ConcurrencyTag` allows it": "",
    ", see `Search_progress`": "",
    ", unless there is a `checkpoint`": "",
    "`default_thickness()` in `untangle()`, and see `Filling_parameters` for `fill()`":
        "in `fill()`, a quarter of the radius of the widest ball inside, or more if the curve would "
        "have over 200,000 nodes",
    ", a `std::array<double, 3>` or any type with members `x()`, `y()` and `z()`": "",
    "a `Curve_flow_3`": "a flow",
    "the final `Curve_flow_3::gradient_norm()`": "the gradient of the flow at the end, dimensionless",
    "The final `Curve_flow_3::gradient_norm()`": "The gradient of the flow at the end, dimensionless",
    "`Curve_flow_3::gradient_norm()`": "the `UntanglingResult.gradient_norm`",
    "`Curve_flow_3::loose_share()`": "the share of loose contacts and bends",
    "the visitor or `progress` ended the run": "the function `progress` returned `False`",
    "`verify_certificate()`": "`verify()`",
    "an `alignment()` of": "an alignment of",
    "as defined by `untangle()`, is": "by rays from its ends to infinity, is",
    "The chirality of a knot or link with a name.":
        "Whether a knot or link with a name is isotopic to its mirror image.",
    "the node of the curve that has it": "the index, among the points of all curves, of the one that has it",
    "the node at the corner": "the index, among the points of all curves, of that at the corner",
    "the last node before it": "that of the last point before it",
    "the node of the strand that is met": "the index of a point of the strand that is met",
    "`data/prime_links.txt`": "data/prime_links.txt"}
used_phrases = set()  # of IN_PYTHON; a test demands all of them


@cache
def enumerations():
    """Each enumeration of the library: its enumerators, with the word and the meaning of each."""
    found = {}
    for name, body in re.findall(r"^enum class (\w+)\n{\n(.*?)\n};", named_parameters.sources(), re.S | re.M):
        said = re.search(rf"^inline const char\* to_string\({name} .*?^}}", named_parameters.sources(), re.S | re.M)
        words = dict(re.findall(r'(?:case \w+::(\w+)|default):\s*return "(.*?)"', said[0] if said else ""))
        entries = re.findall(r"^  ([A-Z]\w*),? *(///< .*(?:\n +///< .*)*)?", body, re.M)
        found[name] = {value: (words.get(value) or words.get("") or value.lower().replace("_", " "),
                               " ".join(re.findall(r"///< (.*)", comment))) for value, comment in entries}
    return found


def word(enumerator, enumeration=None):
    """An enumerator as a word in quotes; those of the same name in other enumerations have the same.
    Another name in capitals stays, for tests to find: it is no reason not to install the module."""
    known = enumerations()
    owners = [enumeration] if enumeration in known else known
    found = {known[owner][enumerator][0] for owner in owners if enumerator in known[owner]}
    return f"`'{found.pop()}'`" if len(found) == 1 else f"`{enumerator}`"


def plain(text):
    """A comment of a header as plain text."""
    text = re.sub(r"\s+", " ", text)
    for cpp, python in IN_PYTHON.items():
        if cpp in text:
            used_phrases.add(cpp)
            text = text.replace(cpp, python)
    text = re.sub(r"\\ref \w+", "manual", text)
    text = re.sub(r"`(\w+)::([A-Z][A-Z_0-9]+)`", lambda m: word(m[2], m[1]), text)
    text = re.sub(r"`([A-Z][A-Z_0-9]+)`", lambda m: word(m[1]), re.sub(r"`([A-Z])`", r"\1", text))
    text = re.sub(r"`(\w+)::(\w+(?:\(\))?)`",
                  lambda m: f"`{RESULTS[m[1]]}.{m[2]}`" if m[1] in RESULTS else f"`{m[2]}`", text)
    text = re.sub(r"`(true|false)`", lambda m: f"`{m[1].title()}`", text)
    text = re.sub(r"[,;]? see `(\w+)\(\)`", lambda m: m[0] if m[1] in OPTIONS else "", text)
    text = re.sub(r"`(\w+)\(\)`", lambda m: f"`{RESULTS[MEASURES]}.{m[1]}`"
                  if m[1] in own_members(MEASURES) else m[0], text)
    text = re.sub(r"\\f\$(.*?)\\f\$", lambda m: re.sub(r"\\(left|right)?", "", m[1]), text)
    return re.sub(r" ?\\cgalCite{.*?}", "", text).replace("\\cgal", "CGAL").strip()


@cache
def own_members(name):
    return tuple(re.findall(r"^  [\w:<>, ]+? (\w+)(?: = [^;]*)?;",
                            re.search(rf"struct {name}\n{{\n(.*?)\n}};", named_parameters.sources(), re.S)[1], re.M))


def of_function(name):
    """What a function of the headers returns, in its first paragraph, without the time it takes."""
    before = re.search(rf"\A.*?\[\[nodiscard\]\] [^;{{(]*\b{name}\(", named_parameters.sources(), re.S)[0]
    comment = re.findall(r"^(?:///| \*) returns (.*\n(?:(?:///| \*) [^\\\n].*\n)*)", before, re.M)[-1]
    text = " ".join(line.strip(" /*") for line in comment.splitlines())
    return plain(re.sub(r" (?:Takes|Linear)[^.]* time\b[^.]*\.", "", text).rstrip("."))


def members(name):
    """Type, name and comment of each documented member of a struct."""
    body = re.search(rf"struct {name}(?: : \w+)?\n{{\n(.*?)\n}};", named_parameters.sources(), re.S)[1]
    comment, found = [], []
    for line in body.splitlines():
        if re.match(r"  ///(?!<)", line):
            comment.append(line.strip(" /"))
        elif member := re.match(r"  ([\w:<>, ]+?) (\w+)(?: = ([^;]*))?; *(?:///< ?(.*))?$", line):
            if member[4]:
                comment.append(member[4])
            found.append([member[1], member[2], comment])
            comment = []
        elif found and (more := re.match(r" +///< ?(.*)", line)):
            found[-1][2].append(more[1])
        elif line.strip():
            comment = []
    return [(kind, member, of_function(member) if text == [f"see `{member}()`"] else plain(" ".join(text)))
            for kind, member, text in found if text]


def summary(name):
    """The first sentence of the comment of a struct."""
    before = named_parameters.sources().partition(f"\nstruct {name}\n")[0]
    block = re.search(r"((?:///.*\n)+|/\*!\n(?: \*.*\n)+)(?:template <.*>\n?)?$", before + "\n")
    text = " ".join(re.sub(r"^ ?(///|/\*!|\*/?) ?", "", line) for line in block[1].splitlines()) if block else ""
    text = plain(re.sub(r"\\(ingroup|headerfile) \S+|\\brief", "", text))
    text = re.sub(r"^The struct `\w+` (?:is )?", "", re.split(r"(?<=\.) ", text)[0])
    return text[:1].upper() + text[1:]
