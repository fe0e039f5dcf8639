#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Writes the parts of the module that repeat the library's structs: its parameters, results and
enumerations, with their documentation. The headers are the only source.

make_interface.py FOLDER    writes enumerations.h, results.h, vfc/_results.py and vfc/_options.py
                            into the folder"""

import pathlib
import re
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "doc/Volume_filling_curves"))
import named_parameters  # noqa: E402

HEADERS = ROOT / "include/CGAL/Volume_filling_curves"
RESULTS = {  # struct in C++: class in Python
    "Curve_flow_statistics": "FlowStatistics", "Untangling_result": "UntanglingResult",
    "Thickness_fit": "ThicknessFit", "Coverage": "Coverage", "Empty_region_3": "EmptyRegion",
    "Shape_excess_3": "ShapeExcess", "Port_neck": "PortNeck", "Filling_result": "FillingResult", "Curve_measures": "CurveMeasures",
    "Certificate_verdict": "Verdict", "Planar_diagram": "PlanarDiagram", "Link_identity": "LinkIdentity"}
OF_POINTS = ("Empty_region_3", "Shape_excess_3", "Port_neck", "Filling_result")  # templates
OPTIONS = {"untangle": "Untangle_signature", "fill": "Fill_signature", "simplify": "Simplify_signature"}
NOT_IN_PYTHON = {"visitor", "progress", "certificate", "checkpoint", "resume_from", "build_name"}
FIELD_TYPES = {
    "std::vector<Port<Point_3>>": "Sequence[Sequence[float]]",
    # of functions of a point; arrays have a row per vertex of the mesh
    "std::function<double(const Point_3&)>": "Callable[[Any], float] | Sequence[float]",
    "std::function<Vector_3(const Point_3&)>": "Callable[[Any], Any] | Sequence[Any]"}
TYPES = {"double": "float", "std::size_t": "int", "int": "int", "bool": "bool", "std::string": "str"}


def enumerations():
    """Each enumeration of the library with its enumerators."""
    found = {}
    for name, body in re.findall(r"^enum class (\w+)\n{\n(.*?)\n};", named_parameters.sources(), re.S | re.M):
        values = re.findall(r"\b([A-Z][A-Z0-9_]*)\b(?= *(?:,|///|\n|$))", re.sub(r"//.*", "", body))
        found[name] = values
    return found


def plain(text):
    """A comment of a header as plain text."""
    text = re.sub(r"\\ref \w+", "manual", text)
    text = re.sub(r"`\w+::([A-Z][A-Z_0-9]+)`", lambda m: "`'" + m[1].lower() + "'`", text)
    text = re.sub(r"`([A-Z][A-Z_0-9]+)`", lambda m: "`'" + m[1].lower() + "'`", text)
    text = re.sub(r"`\w+::(\w+(?:\(\))?)`", r"`\1`", text)
    text = re.sub(r"\\f\$(.*?)\\f\$", lambda m: m[1].replace("\\", ""), text)
    return re.sub(r"\s+", " ", text.replace("\\cgal", "CGAL")).strip()


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
    return [(kind, member, plain(" ".join(text))) for kind, member, text in found if text]


def summary(name):
    """The first sentence of the comment of a struct."""
    before = named_parameters.sources().partition(f"\nstruct {name}\n")[0]
    block = re.search(r"((?:///.*\n)+|/\*!\n(?: \*.*\n)+)(?:template <[^>]*>\n?)?$", before + "\n")
    text = " ".join(re.sub(r"^ ?(///|/\*!|\*/?) ?", "", line) for line in block[1].splitlines()) if block else ""
    text = plain(re.sub(r"\\(ingroup|headerfile) \S+|\\brief", "", text))
    return re.split(r"(?<=\.) ", text)[0]


def python_type(kind):
    if kind in TYPES:
        return TYPES[kind]
    if kind in RESULTS:
        return RESULTS[kind]
    if inner := re.match(r"std::vector<(.*)>$", kind):
        return f"list[{python_type(inner[1])}]"
    if inner := re.match(r"(\w+)<Point_3>$", kind):
        return RESULTS[inner[1]]
    return "np.ndarray" if "Point" in kind else "str"


def enumerations_header():
    yield "#include <CGAL/Volume_filling_curves/fill.h>\n#include <CGAL/Volume_filling_curves/untangle.h>\n"
    yield "#include <algorithm>\n#include <cctype>\n#include <stdexcept>\n#include <string>\n"
    yield "namespace vfc_python {\n\nnamespace VFC = CGAL::Volume_filling_curves;\n"
    yield ("inline std::string in_capitals(std::string name)\n{\n"
           "  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {\n"
           "    return std::isalnum(c) ? static_cast<char>(std::toupper(c)) : '_';\n  });\n"
           "  return name;\n}\n")
    yield "template <typename Enumeration>\nEnumeration enumerator(const std::string& name) = delete;\n"
    used = {kind for name in ("Curve_run_parameters", "Filling_parameters", "Untangling_parameters",
                              "Curve_flow_parameters")
            for kind in (member[1] for member in named_parameters.struct(name)[1].values())}
    for name, values in enumerations().items():
        if name not in used:
            continue
        wanted = ", ".join(value.lower() for value in values)
        yield f"template <>\ninline VFC::{name} enumerator<VFC::{name}>(const std::string& name)\n{{"
        for value in values:
            yield f'  if(in_capitals(name) == "{value}") return VFC::{name}::{value};'
        yield f'  throw std::invalid_argument("\'" + name + "\' is none of {wanted}");\n}}\n'
    yield "} // namespace vfc_python"


def results_header():
    yield '#include "to_python.h"\n'
    yield "namespace vfc_python {\n"
    for name in RESULTS:
        kind = f"VFC::{name}" + ("<Point>" if name in OF_POINTS else "")
        yield f"inline py::dict to_python(const {kind}& value)\n{{\n  py::dict d;"
        yield from (f'  d["{member}"] = to_python(value.{member});' for _, member, _ in members(name))
        yield "  return d;\n}\n"
    yield "} // namespace vfc_python"


def wrapped(text, indent, hanging=""):
    return textwrap.fill(text, 96, initial_indent=indent, subsequent_indent=indent + hanging)


def results_module():
    yield '"""The results of the functions of this module."""\n'
    yield "from __future__ import annotations\n\nfrom dataclasses import dataclass\n"
    yield "import numpy as np\n"
    for name, title in RESULTS.items():
        yield f"\n@dataclass\nclass {title}:"
        yield f'    """{summary(name)}\n\n    Attributes:'
        for _, member, text in members(name):
            yield wrapped(f"{member}: {text}", "        ", "    ")
        yield '    """\n'
        for kind, member, _ in members(name):
            yield f"    {member}: {python_type(kind)}"
        yield ""
    yield "\ndef with_classes(name, members):"
    yield '    """The members of a result, those that are results themselves as objects."""'
    yield "    for member, wrap in NESTED[name].items():"
    yield "        members[member] = wrap(members[member])"
    yield "    return members\n\n"
    yield "NESTED = {"
    for name, title in RESULTS.items():
        wraps = [f'"{member}": {wrap}' for kind, member, _ in members(name) if (wrap := wrapping(kind))]
        yield f'    "{title}": {{{", ".join(wraps)}}},'
    yield "}"


def wrapping(kind):
    """The function that makes a member of a result an object, if it is a result itself."""
    of_items = re.fullmatch(r"std::vector<(\w+)<Point_3>>", kind)
    if of_items and of_items[1] in RESULTS:
        return f"lambda items: [{RESULTS[of_items[1]]}(**item) for item in items]"
    return f"lambda item: {RESULTS[kind]}(**item)" if kind in RESULTS else ""


def option_entries(function):
    """Name, type, default and text of each option of a function."""
    for name, lines in named_parameters.entries(OPTIONS[function]).items():
        if name in NOT_IN_PYTHON:
            continue
        found = dict(re.findall(r"\\cgalParam(\w+?){(.*)}$", "\n".join(lines), re.M))
        kinds = [kind for kind in re.findall(r"`(.*?)`", found["Type"])]
        types = [TYPES.get(kind) or FIELD_TYPES.get(kind, "str") for kind in kinds]
        limits = found.get("Precondition")
        text = plain(found["Description"]) + (f" Must be {limits}." if limits else "")
        yield name, " | ".join(dict.fromkeys(types)), plain(found["Default"]).strip("`'"), text


def options_module():
    yield '"""The keyword arguments that functions pass on to the library: their types and their texts."""\n'
    yield "from __future__ import annotations\n\nfrom typing import Any, Callable, Sequence, TypedDict\n"
    for function in OPTIONS:
        yield f"\nclass {function.capitalize()}Options(TypedDict, total=False):"
        yield from (f"    {name}: {kind}" for name, kind, _, _ in option_entries(function))
        yield ""
    yield "\nOPTIONS = {"
    for function in OPTIONS:
        yield f'    "{function}": """'
        for name, kind, default, text in option_entries(function):
            yield f"    {name} : {kind}, default {default}"
            yield wrapped(text, "        ").replace("\\", "\\\\")
        yield '""",'
    yield "}"


def main(folder):
    (folder / "vfc").mkdir(parents=True, exist_ok=True)
    for file, lines in {"enumerations.h": enumerations_header(), "results.h": results_header(),
                        "vfc/_results.py": results_module(), "vfc/_options.py": options_module()}.items():
        text = "\n".join(lines) + "\n"
        path = folder / file
        if not path.exists() or path.read_text() != text:
            path.write_text(text)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
