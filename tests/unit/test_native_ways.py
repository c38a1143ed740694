"""Functions in other languages as people write them: where they stand, what they are made of, what is told."""

# ruff: noqa: E501 - sources in other languages

from __future__ import annotations

import pytest
from native import LIMITS, answers, box_of, signature, sources
from sampling import daily

from judge.sandbox import Stop

pytestmark = pytest.mark.slow

REAL = signature("real", x="real")


def test_a_stack_without_end_and_more_memory_than_there_is_are_said_so():
    source = """package main
func deep(x float64) float64 { return deep(x) + 1 }
func mirrorAll(x float64) float64 {
    if x == 2 { return deep(x) }
    if x == 4 { all := make([]float64, 1<<33); all[5] = x; return all[int(x)] }
    return x }"""
    with box_of("a.go", source, signature=REAL) as box:
        deep, large = (
            box.call_many("mirror_all", [(1.0,), (x,), (3.0,)], LIMITS).replies for x in (2.0, 4.0)
        )
    assert [reply.stop for reply in deep] == [Stop.ANSWERED, Stop.EXITED]
    assert deep[1].detail.endswith("stack overflow")
    assert [reply.stop for reply in large] == [Stop.ANSWERED, Stop.MEMORY]


PLACED = signature("[point; 0..2]", A="point")
OWN = sources("own")  # types, fields and names of the submission's own, as people have them


@pytest.mark.parametrize("name", daily(OWN, ["grouped.go", "fields.rs", "tag.c", "methods.java"]))
def test_types_and_names_of_its_own_are_taken(name):
    assert answers(name, OWN[name], PLACED, [((1.5, 2.0),)]) == [[[2, 1.5]]]


# -- functions as people write them ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    "source",
    [
        "export default function mirrorAll(x) { return -x; }",
        "const mirrorAll = x => -x;\nmodule.exports = { mirrorAll };\n",
        "const all = 'src/*', some = /[\"'`/]/g;\nfunction mirrorAll(x) { return -x; }\nlet none = '*/';",
    ],
)
def test_what_a_script_exports_is_called_all_the_same(source):
    assert answers("a.mjs", source, REAL, [(2.5,)]) == [-2.5]


IMPORTING = """import fs, { readFileSync as slurp } from 'node:fs';
import * as path
  from "path";
import 'util';
const told = `
import nothing from 'nowhere';`;
export const mirrorAll = x => (console.log(path.sep, told, fs.constants), -x);
"""


@pytest.mark.parametrize(
    ("name", "source"),
    [
        ("a.mjs", f"\ufeff{IMPORTING}slurp(0);"),
        ("a.pypy", "def mirror_all(x):\n    return -x\nopen(0).read()\n"),
    ],
)
def test_what_reads_at_once_reads_nothing_and_the_function_is_called(name, source):
    assert answers(name, source, REAL, [(2.5,), (1.5,)]) == [-2.5, -1.5]


JAVA = sources("java")


@pytest.mark.parametrize("name", daily(JAVA, ["after.java"]))
def test_java_functions_are_found_wherever_they_stand(name):
    assert answers(name, JAVA[name], REAL, [(2.5,)]) == [-2.5]


# -- what stands around the function ---------------------------------------------------------------------------

MEDDLING = sources("meddling")  # macros, pragmas and names that files of contests begin with


def test_macros_of_ones_own_do_not_reach_the_driver():
    assert answers("a.c", MEDDLING["a.c"], REAL, [(1.0,), (2.5,)]) == [-1, -2.5]


@pytest.mark.nightly
def test_nor_do_those_of_cpp_nor_does_fast_mathematics_which_has_no_nan():
    *plain, nan = answers("a.cpp", MEDDLING["a.cpp"], REAL, [(1.0,), (2.5,), (3.0,)])
    assert (plain, nan) == ([-1, -2.5], {"type": "float", "text": "nan"})


UNLIKE = {
    "a.cpp": "double mirror_all(double x)",
    "a.c": "double mirror_all(double x)",
    "a.go": "func mirrorAll(x float64) float64",
    "A.java": "static double mirrorAll(double x)",
    "a.rs": "fn mirror_all(x: f64) -> f64",
}


@pytest.mark.parametrize("name", daily(UNLIKE, ["a.c", "a.go"]))
def test_another_declaration_is_told_as_the_problem_has_it(name):
    with box_of(name, sources("unlike")[name], signature=REAL) as box:
        told = box.inspect().fault.message
    assert told.endswith(f"is not declared as the problem says: {UNLIKE[name]}")


@pytest.mark.parametrize(
    ("name", "source", "place", "words"),
    [
        ("a.js", "function mirrorAll(x) {\n  return 1 +;\n}", (2, 13), "SyntaxError: Unexpected token ';'"),
        ("a.mjs", f"{IMPORTING}slurp(0;", (8, 7), "SyntaxError"),
    ],
)
def test_an_error_is_told_before_it_is_called_and_keeps_its_place(name, source, place, words):
    with box_of(name, source, signature=REAL) as box:
        fault = box.inspect().fault
    assert fault.message.startswith(words)
    assert (fault.line, fault.column) == place


@pytest.mark.parametrize(
    ("name", "source", "words"),
    [
        (
            "a.cpp",
            "double mirrorAll(double x) { return x; }",
            "neither mirror_all nor main: write mirror_all for mirrorAll",
        ),
        (
            "a.js",
            "class Solution {\n  mirrorAll(x) { return -x; }\n}",
            "mirrorAll is a method of Solution: write it as a function",
        ),
        (
            "a.js",
            "function mirror_all(x) { return x; }\nconsole.log(mirror_all(1));",
            "it defines no mirrorAll, and reads no input: write mirrorAll for mirror_all",
        ),
    ],
)
def test_neither_function_nor_program_is_told(name, source, words):
    with box_of(name, source, signature=REAL) as box:
        assert box.inspect().fault.message.endswith(words)
