"""Equal files: the same program under other names, and never two that are not."""

from __future__ import annotations

import pytest

from judge.batch.duplicates import LEAST, equal_files, normal_form
from judge.batch.model import Submission
from judge.practice.stub import make_stub
from judge.problem.find import find_problem

ONE = b'''"""My own."""
from math import hypot, sqrt

def line_count(cx, cy, r, A, B):
    # the distance
    dx, dy = B[0] - A[0], B[1] - A[1]
    if not (dx or dy): return None
    away = abs(dx * (cy - A[1]) - dy * (cx - A[0])) / hypot(dx, dy)
    return 1 if abs(away - r) < 1e-9 else 2 if away < r else 0
'''
RENAMED = b'''from math import hypot, sqrt
def line_count(x, y, radius, start, end):
    """Another's."""
    u, v = (end[0] - start[0],
            end[1] - start[1])
    if not (u or v):
        return None
    d = abs(u * (y - start[1]) - v * (x - start[0])) / hypot(u, v)
    return 1 if abs(d - radius) < 1e-9 else (2 if d < radius else 0)
'''


def told(*sources, least=LEAST, name="{}.py", problem="count"):
    submissions = [
        Submission(f"s{at}", problem, name.format(at), source) for at, source in enumerate(sources)
    ]
    return equal_files(submissions, {problem: find_problem(problem)}, least)


def test_names_spacing_and_comments_make_no_other_program():
    (found,) = told(ONE, RENAMED)
    assert (found.problem, found.students, found.files) == ("count", ("s0", "s1"), ("0.py", "1.py"))
    assert found.what == "identical after removing names, spacing and comments"
    (found,) = told(ONE, ONE)
    assert found.what == "identical files"


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (b"hypot(dx", b"sqrt(dx"),  # an imported name
        (b"1e-9", b"1e-8"),
        (b"away < r", b"away <= r"),
        (b"dx * (cy", b"dy * (cy"),  # another name of its own
    ],
)
def test_what_differs_otherwise_is_not_told(old, new):
    assert old in ONE
    assert told(ONE, ONE.replace(old, new, 1), least=0) == []


def test_the_entry_and_keywords_of_others_stay_what_they_are():
    one = b"def entry(a): return 1\ndef other(a): return 2\n"
    assert normal_form(one, "a.py", "entry") != normal_form(
        one.replace(b"entry", b"x").replace(b"other", b"entry").replace(b"x", b"other"), "a.py", "entry"
    )
    prints = [f"{name} = 1\nprint({name}={name})\n".encode() for name in ("end", "sep")]
    assert normal_form(prints[0], "a.py") != normal_form(prints[1], "a.py")
    calls = [f"def f({name}): return 1\nf({name}=2)\n".encode() for name in ("end", "sep")]
    assert normal_form(calls[0], "a.py") == normal_form(calls[1], "a.py")


def test_one_students_own_files_and_what_is_not_judged_are_not_told():
    twice = [Submission("ann", "count", name, ONE) for name in ("a.py", "b.py")]
    unread = Submission("bob", "count", "c.py", b"", "it is a folder")
    elsewhere = Submission("eve", "segment", "d.py", ONE)
    assert equal_files([*twice, unread, elsewhere], {}) == []


def test_stubs_are_not_told():
    for name in ("vector", "count"):
        stub = make_stub(find_problem(name)).encode()
        assert told(stub, stub + b"\n# mine\n", problem=name, least=0) == []


JAVA = b"""class Solution { // mine
    static int lineCount(double cx, double cy) {
        double dx = cx - 1, s = Math.abs(dx);  /* all */
        for (int i = 0; i < 3; i++) { s += Math.hypot(dx, cy) * i; }
        return s > 0 ? 1 : 0;
    }
}"""
GO = b"""package main
import "math"
func lineCount(cx float64, cy float64) int {
    gap := math.Abs(cx - cy) // mine
    for i := 0; i < 3; i++ { gap += math.Sqrt(cx) }
    if gap > 0 { return 1 }
    return 0
}"""


@pytest.mark.parametrize(
    ("source", "name", "changed", "other"),
    [
        (
            JAVA,
            "{}.java",
            [(b" // mine", b"\n"), (b" /* all */", b" "), (b"i < 3", b"i<3")],
            (b"hypot", b"pow"),
        ),
        (GO, "{}.go", [(b" // mine", b""), (b":= 0", b":=0")], (b"math.Sqrt", b"math.Cbrt")),
    ],
)
def test_other_languages_by_their_words(source, name, changed, other):
    copy = source
    for old, new in changed:
        copy = copy.replace(old, new)
    (found,) = told(source, copy, name=name, least=20)
    assert found.what == "identical after removing spacing and comments"
    assert told(source, source.replace(*other), name=name, least=20) == []


@pytest.mark.parametrize(
    "source",
    [
        b"def (", b"\x00", b"\xff\xfe", b"(" * 5000, b"-" * 9_000 + b"1", b"x = " + b"9" * 60_000,
        b"0x" + b"f" * 9000, b"a" + b".b" * 5_000, b"# coding: nonsense\n", b"#" * 200_000, b"",
    ],
)  # fmt: skip
def test_what_cannot_be_read_is_equal_to_its_own_bytes_alone(source):
    for name in ("a.py", "a.cpp", "a.java", "a.rs", "a.txt"):
        assert normal_form(source, name) == normal_form(source, name)
        assert normal_form(source + b"\nx = 1", name) != normal_form(source, name)


@pytest.mark.parametrize(
    ("source", "like"),
    [
        (b"# coding: utf-7\nx = '+AGE-'\n", b"x = 'a'\n"),  # an encoding that would be believed
        (b"x = 1\n" + b"#" * 70_000, b"x = 1\n"),  # longer than a person writes
        (f"e{chr(0x301) * 1000} = 1\n".encode(), b"x = 1\n"),  # accents that Python would sort
    ],
)
def test_what_may_keep_the_judge_busy_is_not_read(source, like):
    assert normal_form(source, "a.py") != normal_form(like, "a.py")
