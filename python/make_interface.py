#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Writes the parts of the module that repeat the library's structs: its parameters, results and
enumerations, with their documentation. The headers are the only source.

make_interface.py FOLDER    writes enumerations.h, results.h, vfc/_results.py, vfc/_options.py and
                            the stub vfc/__init__.pyi into the folder"""

import ast
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
    "Shape_excess_3": "ShapeExcess", "Port_neck": "PortNeck", "Filling_result": "FillingResult",
    "Curve_measures": "CurveMeasures",
    "Certificate_verdict": "Verdict", "Arc_conflict": "ArcConflict", "Arc_spline_piece": "ArcPieces",
    "Arc_spline_path": "ArcPath", "Arc_spline": "ArcSpline", "Planar_diagram": "PlanarDiagram", "Link_identity": "LinkIdentity",
    "Knot_share": "KnotShare", "Closure_knot": "ClosureKnot", "Chain_section": "ChainSections",
    "Chain_identity": "ChainIdentity"}
OF_POINTS = ("Empty_region_3", "Shape_excess_3", "Port_neck", "Filling_result", "Arc_spline_piece",
             "Arc_spline_path", "Arc_spline")  # templates
IN_ARRAYS = ("Arc_spline_piece", "Chain_section")  # many of them are one result, whose members are arrays with a row each
OPTIONS = {"untangle": "Untangle_signature", "fill": "Fill_signature", "simplify": "Simplify_signature",
           "identify_chain": "Chain_signature"}
NOT_IN_PYTHON = {"visitor", "progress", "certificate", "checkpoint", "resume_from", "build_name"}
FIELD_TYPES = {
    "std::vector<Port<Point_3>>": "Sequence[Sequence[float]]",
    "std::vector<double>": "Sequence[float]",
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
    text = re.sub(r"`(\w+)::(\w+(?:\(\))?)`",
                  lambda m: f"`{RESULTS[m[1]]}.{m[2]}`" if m[1] in RESULTS else f"`{m[2]}`", text)
    text = re.sub(r"`(true|false)`", lambda m: f"`{m[1].title()}`", text)
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


def is_in_arrays(kind):
    return kind.partition("<")[0] in IN_ARRAYS


def python_type(kind):
    if kind in TYPES:
        return TYPES[kind]
    if kind in RESULTS:
        return RESULTS[kind]
    if inner := re.match(r"std::vector<(.*)>$", kind):
        item = python_type(inner[1])
        return item if is_in_arrays(inner[1]) else f"list[{item}]"
    if inner := re.match(r"(\w+)<(?:Point_3)?>$", kind):
        return RESULTS[inner[1]]
    return "np.ndarray" if "Point" in kind else "str"


def guarded(name, lines):
    """The lines of a header with an include guard."""
    guard = f"VFC_PYTHON_{name}_H"
    return [f"#ifndef {guard}\n#define {guard}\n", *lines, f"\n#endif // {guard}"]


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
        if name in IN_ARRAYS:
            yield f"inline py::dict to_python(const std::vector<{kind}>& rows)\n{{\n  py::dict d;"
            value = f"array_of(rows, &{kind}::%s)"
        else:
            yield f"inline py::dict to_python(const {kind}& value)\n{{\n  py::dict d;"
            value = "to_python(value.%s)"
        yield from (f'  d["{member}"] = {value % member};' for _, member, _ in members(name))
        yield "  return d;\n}\n"
    yield "} // namespace vfc_python"


def wrapped(text, indent, hanging=""):
    return textwrap.fill(text, 96, initial_indent=indent, subsequent_indent=indent + hanging)


def results_module():
    yield '"""The results of the functions of this module."""\n'
    yield "from __future__ import annotations\n\nfrom dataclasses import dataclass\n"
    yield "import numpy as np\n\nfrom .representation import Short\n"
    for name, title in RESULTS.items():
        yield f"\n@dataclass(repr=False)\nclass {title}(Short):"
        yield f'    """{summary(name)}\n\n    Attributes:'
        for _, member, text in members(name):
            yield wrapped(f"{member}: {text}", "        ", "    ")
        yield '    """\n'
        for kind, member, _ in members(name):
            yield f"    {member}: {'np.ndarray' if name in IN_ARRAYS else python_type(kind)}"
        if ("bool", "is_valid") in [(kind, member) for kind, member, _ in members(name)]:
            yield "\n    def __bool__(self) -> bool:\n        return self.is_valid"
        yield ""
    yield "\ndef with_classes(name, members):"
    yield '    """The members of a result, those that are results themselves as objects."""'
    yield "    for member, kind in NESTED[name].items():"
    yield "        value = members[member]"
    yield "        members[member] = ([made(kind, item) for item in value] if isinstance(value, list)"
    yield "                           else made(kind, value))"
    yield "    return members\n\n"
    yield "def made(name, members):"
    yield '    """The result with these members."""'
    yield "    return globals()[name](**with_classes(name, members))\n\n"
    yield "NESTED = {"
    for name, title in RESULTS.items():
        nested = {member: inner[0] for kind, member, _ in members(name)
                  if (inner := [title for title in RESULTS.values() if title in python_type(kind)])}
        yield f'    "{title}": {nested},'
    yield "}"


def words(kind):
    """The type of an enumeration: its enumerators as words."""
    values = enumerations().get(kind)
    return "Literal[%s]" % ", ".join(repr(value.lower()) for value in values) if values else "str"


def option_entries(function):
    """Name, type, default and text of each option of a function."""
    for name, lines in named_parameters.entries(OPTIONS[function]).items():
        if name in NOT_IN_PYTHON:
            continue
        found = dict(re.findall(r"\\cgalParam(\w+?){(.*)}$", "\n".join(lines), re.M))
        kinds = [kind for kind in re.findall(r"`(.*?)`", found["Type"])]
        types = [TYPES.get(kind) or FIELD_TYPES.get(kind) or words(kind) for kind in kinds]
        limits = found.get("Precondition")
        text = plain(found["Description"]) + (f" Must be {limits}." if limits else "")
        yield name, " | ".join(dict.fromkeys(types)), plain(found["Default"]).strip("`'").replace("false", "False"), text


def options_module():
    yield '"""What is said of the keyword arguments that functions pass on to the library."""\n'
    yield "OPTIONS = {"
    for function in OPTIONS:
        yield f'    "{function}": """'
        for name, kind, default, text in option_entries(function):
            yield f"    {name} : {kind}, default {default}"
            yield wrapped(text, "        ").replace("\\", "\\\\")
        yield '""",'
    yield "}"


def signature(function):
    """The head of a function that passes options on, with each option by its name."""
    head, body = ast.unparse(function).partition("**options: Any")[::2]
    options = "".join(f",\n    {name}: {kind} = ..." for name, kind, *_ in option_entries(function.name))
    return head.rstrip(", ") + options + body.partition(":\n")[0] + ": ..."


def stub():
    """What type checkers and editors read: the package, with all options of its functions."""
    package = pathlib.Path(__file__).parent / "vfc"
    imports = [node for node in ast.parse((package / "__init__.py").read_text()).body
               if isinstance(node, ast.ImportFrom)]
    yield "from typing import Any, Callable, Literal, Optional, Sequence\n"
    yield "from .curves import Closed, Curves\nfrom .runs import Progress"
    for node in imports:
        for name in (alias.name for alias in node.names):
            if node.module == "_vfc":
                yield f"class {name}(RuntimeError): ..."
            elif name not in OPTIONS:
                yield f"from .{node.module} import {name} as {name}"
    for node in (node for file in ("runs.py", "identification.py")
                 for node in ast.parse((package / file).read_text()).body):
        if isinstance(node, ast.FunctionDef) and node.name in OPTIONS:
            yield "\n" + signature(node)


def main(folder):
    (folder / "vfc").mkdir(parents=True, exist_ok=True)
    for file, lines in {"enumerations.h": guarded("ENUMERATIONS", enumerations_header()),
                        "results.h": guarded("RESULTS", results_header()),
                        "vfc/_results.py": results_module(), "vfc/_options.py": options_module(),
                        "vfc/__init__.pyi": stub()}.items():
        text = "\n".join(lines) + "\n"
        path = folder / file
        if not path.exists() or path.read_text() != text:
            path.write_text(text)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
