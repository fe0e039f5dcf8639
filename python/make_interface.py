#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Writes the parts of the module that repeat the library's structs: its parameters, results and
enumerations, with their documentation. The headers are the only source.

make_interface.py FOLDER    writes enumerations.h, results.h, vfc/_results.py, vfc/_options.py and
                            the stub vfc/__init__.pyi into the folder"""

import ast
import math
import pathlib
import re
import sys
import textwrap

sys.dont_write_bytecode = True
from read_headers import (OPTIONS, RESULTS, enumerations, members, named_parameters,  # noqa: E402
                          plain, summary)

OF_POINTS = ("Empty_region_3", "Shape_excess_3", "Port_neck", "Filling_result", "Arc_spline_piece",
             "Arc_spline_path", "Arc_spline")  # templates
IN_ARRAYS = ("Arc_spline_piece", "Chain_section")  # many of them are one result, whose members are arrays with a row each
NOT_IN_PYTHON = {"visitor", "progress", "certificate", "checkpoint", "resume_from", "build_name"}
FIELD_TYPES = {
    "std::vector<Port<Point_3>>": "Sequence[Sequence[float]]",
    "std::vector<double>": "Sequence[float]",
    # of functions of a point; arrays have a row per vertex of the mesh
    "std::function<double(const Point_3&)>": "Callable[[Any], float] | Sequence[float]",
    "std::function<Vector_3(const Point_3&)>": "Callable[[Any], Any] | Sequence[Any]"}
TYPES = {"double": "float", "std::size_t": "int", "std::uint32_t": "int", "int": "int",
         "bool": "bool", "std::string": "str"}


def is_in_arrays(kind):
    return kind.partition("<")[0] in IN_ARRAYS


def python_type(kind):
    if kind in TYPES:
        return TYPES[kind]
    if kind in RESULTS:
        return RESULTS[kind]
    if kind in enumerations():
        return literal(kind)
    if inner := re.match(r"(\w+)<(?:Point_3)?>$", kind):
        return RESULTS[inner[1]]
    if re.fullmatch(r"(std::vector<|std::array<)?Point_3(>|, \d+>)?", kind):
        return "np.ndarray"
    if inner := re.match(r"std::(?:vector<(.*)>|array<(.*), \d+>)$", kind):
        inner = inner[1] or inner[2]
        return python_type(inner) if is_in_arrays(inner) else f"list[{python_type(inner)}]"
    raise SystemExit(f"{kind} has no type in Python")


def literal(kind):
    """The type of an enumeration: its enumerators as words."""
    return "Literal[%s]" % ", ".join(repr(value) for value, _ in enumerations()[kind].values())


def meanings(kind, indent):
    """A line for each word of an enumeration, with its meaning, if the type is one or a list of such."""
    for name, text in enumerations().get(re.sub(r"std::vector<(.*)>", r"\1", kind), {}).values():
        yield wrapped(f"{name!r}: {plain(text)}", indent, "    ")


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
    yield ("template <typename Enumeration>\n"
           "Enumeration enumerator(const std::string& option, const std::string& name) = delete;\n")
    used = {kind for name in ("Curve_run_parameters", "Filling_parameters", "Untangling_parameters",
                              "Curve_flow_parameters")
            for kind in (member[1] for member in named_parameters.struct(name)[1].values())}
    for name, values in enumerations().items():
        if name not in used:
            continue
        wanted = ", ".join(value for value, _ in values.values())
        yield (f"template <>\ninline VFC::{name} enumerator<VFC::{name}>(const std::string& option, "
               "const std::string& name)\n{")
        for value in values:
            yield f'  if(in_capitals(name) == "{value}") return VFC::{name}::{value};'
        yield ('  throw std::invalid_argument(option + " is \'" + name + '
               f'"\', but must be one of {wanted}");\n}}\n')
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
    yield "from __future__ import annotations\n\nfrom dataclasses import dataclass\nfrom typing import Literal\n"
    yield "import numpy as np\n\nfrom .representation import Short\n"
    for name, title in RESULTS.items():
        yield f"\n@dataclass(repr=False, eq=False)\nclass {title}(Short):"
        yield wrapped(f'"""{summary(name)}', "    ") + "\n\n    Attributes:"
        for kind, member, text in members(name):
            yield wrapped(f"{member}: {text}", "        ", "    ")
            yield from meanings(kind, "            ")
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


def default_value(text):
    """The value of a default in the documentation of a header."""
    text = plain(text).strip("`")
    if text[0] == "'":
        return text.strip("'")
    named = {"infinity": math.inf, "none": None, "true": True, "True": True, "false": False, "False": False}
    if text in named:
        return named[text]
    factors = [ast.literal_eval(factor) for factor in text.split(" * ")]
    return round(math.prod(factors), 9) if len(factors) > 1 else factors[0]


def without_default(text):
    """The description of an option, whose default stands elsewhere."""
    text = re.sub(r"(; |(?<=\.) )(?:`\w+`|\w+) by default(?=\.)", r"\1", text)
    text = re.sub(r"; \.|(?<=\.) \.", lambda m: "." if m[0] == "; ." else "", text)
    return text.replace(" (default)", "")


def option_entries(function):
    """Name, type, default, text and words of each option of a function."""
    for name, lines in named_parameters.entries(OPTIONS[function]).items():
        if name in NOT_IN_PYTHON:
            continue
        found = dict(re.findall(r"\\cgalParam(\w+?){(.*)}$", "\n".join(lines), re.M))
        kinds = [kind for kind in re.findall(r"`(.*?)`", found["Type"])]
        types = [FIELD_TYPES.get(kind) or python_type(kind) for kind in kinds]
        limits = found.get("Precondition")
        text = without_default(plain(found["Description"])) + (f" Must be {limits}." if limits else "")
        words = [line for kind in kinds for line in meanings(kind, "        ")]
        yield name, " | ".join(dict.fromkeys(types)), default_value(found["Default"]), text, words


def options_module():
    yield '"""The keyword arguments that functions pass on to the library: texts and defaults."""\n'
    yield "from math import inf\n\nTEXTS = {"
    for function in OPTIONS:
        yield f'    "{function}": """'
        for name, kind, default, text, words in option_entries(function):
            yield f"    {name} : {kind}, default {default!r}"
            yield from (line.replace("\\", "\\\\") for line in [wrapped(text, "        "), *words])
        yield '""",'
    yield "}\n\nDEFAULTS = {"
    for function in OPTIONS:
        defaults = {name: default for name, _, default, *_ in option_entries(function)}
        yield f'    "{function}": {defaults},'
    yield '}\n\nSTAGES = """'
    yield from meanings("Run_stage", "            ")
    yield '"""'


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
                yield "__version__: str" if name == "__version__" else f"class {name}(RuntimeError): ..."
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
