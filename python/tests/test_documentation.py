# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Tests of what the package says of itself: docstrings, signatures, the stub, and types of results."""

import ast
import dataclasses
import inspect
import pathlib
import re
import typing
import unittest

from support import CUBE_FACES, CUBE_VERTICES, SQUARE, circle

import vfc
from vfc import _options

WITH_OPTIONS = tuple(_options.DEFAULTS)
STUB = pathlib.Path(vfc.__file__).with_suffix(".pyi")


def public():
    return {name: value for name, value in vars(vfc).items()
            if not name.startswith("_") and (inspect.isfunction(value) or inspect.isclass(value))}


def documented():
    """Each public name with its docstring."""
    for name, value in public().items():
        yield name, inspect.getdoc(value) or ""


def stub_functions():
    return {node.name: node for node in ast.parse(STUB.read_text()).body
            if isinstance(node, ast.FunctionDef)}


def options_in_doc(function):
    return set(re.findall(r"^    (\w+) : ", function.__doc__, re.M))


def members_and_options():
    """What a back-quoted word of a docstring may name besides the public names."""
    names = {field.name for value in public().values() if dataclasses.is_dataclass(value)
             for field in dataclasses.fields(value)}
    for value in public().values():
        if inspect.isfunction(value):
            names |= set(inspect.signature(value).parameters)
    return names


def words_of(kind):
    """The words of a Literal, in a list or not; None of other types."""
    inner = typing.get_args(kind)[0] if typing.get_origin(kind) is list else kind
    return typing.get_args(inner) if typing.get_origin(inner) is typing.Literal else None


def words():
    kinds = [kind for value in public().values() if dataclasses.is_dataclass(value)
             for kind in typing.get_type_hints(value).values()]
    text = "".join(value.__doc__ or "" for value in public().values())
    literals = re.findall(r"Literal\[(.*?)\]", text)
    return ({word for kind in kinds for word in words_of(kind) or ()} |
            set(re.findall(r"'(.*?)'", " ".join(literals))))


class Docstrings(unittest.TestCase):
    def test_every_public_name_has_one_with_a_summary(self):
        for name, text in documented():
            self.assertRegex(text, r"(?s)^[A-Z].*[\w)]", name)

    def test_they_speak_of_python_only(self):
        for name, text in documented():
            for word in ("::", r"\bstd\b", r"\\\w", "The struct", "ConcurrencyTag", r"\b_3\b", "nullptr",
                         "by default\\.", r"\(default\)"):
                self.assertNotRegex(text, word, name)

    def test_every_name_in_back_quotes_exists(self):
        known = set(public()) | members_and_options() | {"True", "False", "None"}
        for name, text in documented():
            for quoted in re.findall(r"`([^`]*)`", re.sub(r"\s+", " ", text)):
                owner, _, member = quoted.removesuffix("()").rpartition(".")
                if quoted.startswith("'"):
                    self.assertIn(quoted.strip("'"), words(), name)
                elif owner:
                    self.assertIn(member, typing.get_type_hints(getattr(vfc, owner)), name)
                else:
                    self.assertIn(member, known, name)

    def test_the_words_that_a_member_can_be_have_meanings(self):
        for name, value in public().items():
            if not dataclasses.is_dataclass(value):
                continue
            for member, kind in typing.get_type_hints(value).items():
                for word in words_of(kind) or ():
                    self.assertRegex(value.__doc__, rf"\n            '{word}': \w", f"{name}.{member}")

    def test_the_version_is_that_of_the_project(self):
        project = (pathlib.Path(__file__).parents[2] / "pyproject.toml").read_text()
        self.assertEqual(vfc.__version__, re.search(r'^version = "(.*)"', project, re.M)[1])


class Options(unittest.TestCase):
    """Those that functions pass on to the library."""

    def test_docstring_stub_and_signature_have_the_same(self):
        for name in WITH_OPTIONS:
            function, head = getattr(vfc, name), stub_functions()[name].args
            signature = set(inspect.signature(function).parameters)
            self.assertEqual({arg.arg for arg in head.args + head.kwonlyargs}, signature, name)
            self.assertEqual(options_in_doc(function) - {"domain"},
                             signature - {"domain", "faces"}, name)

    def test_the_library_takes_each_with_its_default(self):
        cube = vfc.Mesh(CUBE_VERTICES, CUBE_FACES)
        for name, argument in [("untangle", circle()), ("simplify", circle()), ("fill", cube),
                               ("identify_chain", circle())]:
            function, defaults = getattr(vfc, name), _options.DEFAULTS[name]
            short = {} if "time_limit" not in defaults else {"number_of_iterations": 3}
            given, plain = function(argument, **{**defaults, **short}), function(argument, **short)
            self.assertEqual(repr(given), repr(plain))

    def test_the_library_takes_each_word(self):
        for name, option, word in [("untangle", "strategy", "auto"), ("fill", "wall", "keep clear"),
                                   ("untangle", "preconditioner", "quasi-newton")]:
            kind = re.search(rf"^    {option} : Literal\[(.*)\]", getattr(vfc, name).__doc__, re.M)[1]
            self.assertIn(word, ast.literal_eval(f"[{kind}]"))
            for word in ast.literal_eval(f"[{kind}]"):
                arguments = [circle()] if name == "untangle" else [vfc.Ball((0, 0, 0), 1)]
                getattr(vfc, name)(*arguments, **{option: word}, number_of_iterations=1)


class Types(unittest.TestCase):
    """Values of results are of the types that are said."""

    def check(self, value, kind, where):
        origin, inner = typing.get_origin(kind), typing.get_args(kind)
        if origin is typing.Literal:
            self.assertIn(value, inner, where)
        elif origin is list:
            self.assertIsInstance(value, list, where)
            for item in value:
                self.check(item, inner[0], where)
        elif origin is typing.Union or kind is typing.Any:
            return
        else:
            self.assertIsInstance(value, kind, where)
            if dataclasses.is_dataclass(kind):
                self.check_members(value)

    def check_members(self, result):
        for member, kind in typing.get_type_hints(type(result)).items():
            self.check(getattr(result, member), kind, f"{type(result).__name__}.{member}")

    def test_members_have_them(self):
        knot = vfc.hard_unknot(60, random_seed=3)
        cube = vfc.Mesh(CUBE_VERTICES, CUBE_FACES)
        run = vfc.untangle(knot, certificate=True, bend_radius=1, number_of_iterations=50)
        needle = [[0.95, 0.05, -1], [0.95, 0.05, 1]]
        for result in [run, vfc.fill(cube, thickness=0.3, ports=[(0.5, 0.5, 0), (0.5, 0.5, 1)]),
                       vfc.fill(cube, length=4, number_of_iterations=5), vfc.simplify(knot),
                       vfc.verify(run.certificate, knot, run.curves), vfc.measure([knot, knot + 99]),
                       vfc.identify(vfc.torus_knot(2, 4)), vfc.identify(vfc.torus_knot(2, 3)),
                       vfc.identify_chain(knot, closures=10, find_core=True, stride=10),
                       vfc.coverage(circle(), vfc.Ball((0, 0, 0), 2), 0.5, samples=100),
                       vfc.arc_spline([[[0, 0, 0], [1, 0, 0], [1, 1, 0]], needle], closed=False),
                       vfc.wall_distance(circle(), vfc.Ball((0, 0, 0), 2)),
                       vfc.repair(CUBE_VERTICES, CUBE_FACES[1:]),
                       *vfc.check_mesh(CUBE_VERTICES, CUBE_FACES[1:]),
                       *vfc.check_curves([circle(), circle()])]:
            self.check_members(result)

    def test_results_are_compared_by_identity(self):
        first, second = vfc.simplify(circle()), vfc.simplify(circle())
        self.assertTrue(first == first and first != second)
        self.assertEqual(len({first, second}), 2)

    def test_functions_say_what_they_return(self):
        points, edges = vfc.outside(circle(), vfc.Ball((0, 0, 0), 0.5))
        self.check(points, list[int], "outside")
        self.check(edges, list[list[int]], "outside")


class Representations(unittest.TestCase):
    def test_a_repr_says_what_it_is(self):
        result = vfc.untangle(vfc.hard_unknot(random_seed=3))
        self.assertRegex(repr(result), r"^<Untangled: unknotted, \d+ iterations, \d+ points>$")
        self.assertEqual(repr(vfc.Ball((0, 0, 0), 2)), "Ball([0, 0, 0], 2)")
        self.assertEqual(repr(vfc.Polygons(SQUARE)), "Polygons(1 polygons, 0 holes)")
        self.assertEqual(repr(vfc.Network(circle(), [[0, 1]])), "<Network: 16 points, 1 edges>")
        self.assertEqual(repr(vfc.Mesh(CUBE_VERTICES, CUBE_FACES)), "Mesh(8 vertices, 12 faces)")
        self.assertEqual(repr(vfc.simplify([circle(), circle(at=(5, 0, 0))])),
                         "<Simplified: 26 points removed, 2 curves, 6 points>")
        self.assertEqual(repr(vfc.repair(CUBE_VERTICES, CUBE_FACES)),
                         "<RepairedMesh: 8 vertices, 12 faces, 0 steps>")
        self.assertRegex(repr(vfc.fill(CUBE_VERTICES, CUBE_FACES, thickness=0.3)),
                         r"^<Filled: \w+, \d+ % within r = 0.3, \d+ points>$")

    def test_the_repr_of_an_interrupted_filling_has_no_share(self):
        result = vfc.fill(CUBE_VERTICES, CUBE_FACES, ports=[(0.5, 0.5, 0), (0.5, 0.5, 1)],
                          progress=lambda p: False)
        self.assertEqual(repr(result), "<Filled: interrupted, 0 curves, 0 points>")
        self.assertEqual((result.curves, result.closed), ([], []))

    def test_help_and_signatures_name_the_options(self):
        self.assertIn("lower_ropelength: bool = ...", STUB.read_text())
        self.assertIn("lower_ropelength=False", str(inspect.signature(vfc.untangle)))
        self.assertIn("lower_ropelength : bool, default False", vfc.untangle.__doc__)
        self.assertIn("unfilled_fraction:", vfc.Filled.__doc__)

    def test_the_stub_has_every_name(self):
        named = {alias.asname for node in ast.parse(STUB.read_text()).body
                 if isinstance(node, ast.ImportFrom) for alias in node.names}
        self.assertLessEqual(set(public()) - {"Interrupted"}, named | set(stub_functions()))


if __name__ == "__main__":
    unittest.main()
