"""What is said of a file in which nothing can be called, and of one that is no program at all."""

from __future__ import annotations

import re
import sys

import pytest

import judge
from judge.mistakes.family import read_makers
from judge.problem.find import find_problem, problem_folders
from judge.report.tell import tell

KATA = "which-side"
ENTRY = find_problem(KATA).entry
ANSWER = b"def ENTRY(A, B, P):\n    return 1\n"
FAULTS = [
    (b"print(undefined_name)\n", "NameError: name 'undefined_name' is not defined (line 1)"),
    (
        b"import subprocess\nsubprocess.run(['echo'])\n",
        "line 2: PermissionError: [Errno 1] Operation not permitted.",
    ),
    (b"from multiprocessing import Lock\nLock()\n" + ANSWER, ". A submission may start no process."),
    (
        b"import os\n" + ANSWER.replace(b"1", b"os.fork()"),
        "line 3: PermissionError: [Errno 1] Operation not permitted",
    ),
    (b"import tempfile\ntempfile.TemporaryFile()\n" + ANSWER, ". A submission may write no file."),
    (ANSWER.replace(b"return", b"retrun"), "line 2: retrun is not a word of Python. return?"),
    (ANSWER.replace(b"return 1", b"retrun (1)"), "line 2: retrun is not a word of Python. return?"),
    (b'NOTES = """\ndef ENTRY(A, B, P):\n    return 1\n"""\n', "stands in a text (line 2)"),
    (b"x = 1  # def ENTRY(A, B, P):\n", "stands in a comment (line 1)"),
    (b"class Solution:\n    def ENTRY(self, A, B, P):\n        return 1\n", "in class Solution (line 2)"),
    (b"def main():\n    def ENTRY(A, B, P):\n        return 1\n", "in function main (line 2)"),
    (
        b"class Solution:\n    def NEARLY(self, A, B, P):\n        return 1\n",
        "Is NEARLY in class Solution (line 2) meant? Rename it ENTRY and move it to the left margin.",
    ),
    (b"def ENTR\xd0\x83(A, B, P):\n    return 1\n", "has 'Ѓ' (U+0403)"),
    (b"def NEARLY(A, B, P):\n    return 1\n", "is NEARLY (line 1) meant?"),
    (b"# nothing yet\n\n", "The file holds no program."),
    (b"", "The file holds no program."),
    (b"x = 1\n", "There is no ENTRY: write def ENTRY("),
    (b"import maths\ndef ENTRY(A, B, P):\n    return 1\n", "no module maths; did you mean math?"),
    (b"import torch\ndef ENTRY(A, B, P):\n    return 1\n", "-m pip install torch"),
    (b"import cv2\ndef ENTRY(A, B, P):\n    return 1\n", "-m pip install opencv-python"),
    (b"%PDF-1.4\n%\xe2\xe3\n", "This is a PDF file, not a program."),
    (b"PK\x03\x04\x00\x00", "This is a zip file, not a program."),
    (b"<!DOCTYPE html>\n<html>", "This is a web page (HTML), not a program."),
    (b'{"cells": [], "nbformat": 4}\n', "This is a notebook. Export it: File, Save as, .py"),
    (b"x = 1\n<<<<<<< HEAD\n", "Line 2 is a merge conflict"),
    (b">>> x = 1\n", "Line 1 is a dialog with Python"),
    (b"```python\n", "Line 1 is a fence of Markdown"),
    (b"@@ -1 +1 @@\n", "Line 1 is a diff"),
]


def near(text: bytes) -> bytes:
    first, _, rest = ENTRY.partition("_")
    return text.replace(b"NEARLY", f"{first}{rest.title()}".encode()).replace(b"ENTR", ENTRY[:-1].encode())


@pytest.mark.parametrize(("source", "said"), FAULTS)
def test_the_obstacle_is_told(source, said):
    source = source.replace(b"ENTRY", ENTRY.encode())
    shown = judge.judge(KATA, near(source), name="mine.py")
    first, _, rest = ENTRY.partition("_")
    expected = said.replace("ENTRY", ENTRY).replace("NEARLY", f"{first}{rest.title()}")
    told = tell(find_problem(KATA), shown, source)
    assert expected in told.happened
    assert shown.pitfall is None


@pytest.mark.parametrize(
    ("source", "said"),
    [
        (ANSWER.replace(b"1", b"1 // 0"), "ZeroDivisionError: integer division or modulo by zero, at line 2"),
        (
            ANSWER.replace(b"1", b"__import__('maths')"),
            "ModuleNotFoundError: No module named 'maths', at line 2",
        ),
        (
            b"# def ENTRY(A, B, P):\n" + ANSWER.replace(b"1", b"A[2]"),
            "IndexError: tuple index out of range, at line 3",
        ),
    ],
)
def test_an_exception_of_each_call_is_all_that_is_told(source, said):
    source = source.replace(b"ENTRY", ENTRY.encode())
    shown = judge.judge(KATA, source, name="mine.py")
    assert (shown.hurdle, shown.pitfall) == (None, None)
    assert tell(find_problem(KATA), shown, source).happened == said


@pytest.mark.parametrize("near", [b"", b"def NEARLY(A, B, P):\n    return 1\n"])
def test_an_exception_of_a_program_comes_before_what_is_guessed(near):
    first, _, rest = ENTRY.partition("_")
    source = near.replace(b"NEARLY", f"{first}{rest.title()}".encode()) + b"import sys\nprint(sys.argv[1])\n"
    shown = judge.judge(KATA, source, name="mine.py")
    happened = tell(find_problem(KATA), shown, source).happened
    assert happened.startswith("IndexError: list index out of range"), happened


@pytest.mark.skipif(sys.version_info >= (3, 12), reason="this Python knows it")
@pytest.mark.parametrize("line", [b"type P = tuple[int, int]\n", b"def first[T](x: T): return x\n"])
def test_what_a_newer_python_brought_is_told(line):
    shown = judge.judge(KATA, line + ANSWER, name="mine.py")
    assert "this is Python 3.12; the judge runs 3.11" in tell(None, shown).happened


def test_another_order_of_the_parameters_comes_before_any_name():
    source = ANSWER.replace(b"ENTRY(A, B, P)", b"which_side(P, B, A)")
    told = tell(find_problem(KATA), judge.judge(KATA, source, name="mine.py"), source)
    assert told.mistake == "The parameters are (P, B, A); they are handed over as (A, B, P)."
    assert told.advice == ()


@pytest.mark.slow
def test_objects_are_no_points_and_no_single_answer():
    source = b"class P: pass\ndef circle_segment(cx, cy, r, A, B):\n    return [P(), P()]\n"
    shown = judge.judge("segment", source, name="mine.py")
    assert "a value of type P where point 1 is expected" in shown.counterexample.message
    assert shown.pitfall is None


def test_a_program_that_reads_its_input_is_told_nothing_of_an_entry():
    source = b"class Solution:\n    def ENTRY(self):\n        return 1\n"
    source += b"import sys\nfor line in sys.stdin:\n    print(7)\n"
    shown = judge.judge(KATA, source.replace(b"ENTRY", ENTRY.encode()), name="mine.py")
    assert shown.hurdle is None


FORMS = [
    ('return found or "no intersection"', "none-for-empty"),
    ("return [number for point in found for number in point]", "points-in-one-list"),
    ("return found[0] if len(found) == 1 else found", "point-not-in-a-list"),
    ("return str(found)", "text-for-a-value"),
]


@pytest.mark.parametrize(("ending", "name"), FORMS)
def test_a_fault_of_form_is_named(ending, name):
    right = find_problem("segment").solutions / "accepted" / "exact.py"
    source = right.read_text().replace("def circle_segment(", "def right(")
    source += f"\n\ndef circle_segment(*case):\n    found = right(*case)\n    {ending}\n"
    assert judge.judge("segment", source, name="mine.py").pitfall.names == (name,)


SIDE = """
def which_side(A, B, P):
    c = (B[0] - A[0]) * (P[1] - A[1]) - (B[1] - A[1]) * (P[0] - A[0])
    return 0 if c == 0 else -1 if c > 0 else 1
"""
FIXED = """
def line_count(cx, cy, r, A, B):
    if A == B:
        return None
    dx, dy = B[0] - A[0], B[1] - A[1]
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    disc = r * r * (dx * dx + dy * dy) - k * k
    if abs(disc) < 1e-9:
        return 1
    return 2 if disc > 0 else 0
"""
SECOND = """
from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ux, uy, ex, ey = B[0] - A[0], B[1] - A[1], A[0] - cx, A[1] - cy
    length = hypot(ux, uy)
    slack = 1e-9 * max(r, abs(ex), abs(ey), abs(B[0] - cx), abs(B[1] - cy))
    if length == 0:
        return [A] if abs(hypot(ex, ey) - r) <= slack else []
    ux, uy = ux / length, uy / length
    foot, d = -ex * ux - ey * uy, abs(ux * ey - uy * ex)
    if d > r + slack:
        return []
    s = foot + (sqrt((r - d) * (r + d)) if d < r - slack else 0.0)
    if not -slack <= s <= length + slack:
        return []
    s = min(max(s, 0.0), length)
    return [(A[0] + s * ux, A[1] + s * uy)]
"""
SEEN = [
    ("segment", SECOND, "first-root-only", "Only one of two points is returned."),
    (
        "which-side",
        SIDE,
        "sides-exchanged",
        "Left and right are exchanged. For example, the cross product is taken from P to A.",
    ),
    (
        "count",
        FIXED,
        "absolute-epsilon",
        (
            "The answer changes with the size of the figure. "
            "For example, something is compared with a fixed 1e-9."
        ),
    ),
]


@pytest.mark.parametrize(("kata", "source", "name", "said"), SEEN)
@pytest.mark.slow
def test_what_was_seen_comes_before_an_example(kata, source, name, said):
    shown = judge.judge(kata, source.encode(), name="mine.py")
    assert shown.pitfall.names == (name,)
    assert shown.pitfall.advice == (said,)


def test_nothing_seen_speaks_in_code():
    for folder in problem_folders():
        for maker in read_makers(find_problem(folder.name)).all:
            assert not re.search(r"`|[=!<>]=|\*\*|//", maker.seen), (folder.name, maker.file, maker.seen)
