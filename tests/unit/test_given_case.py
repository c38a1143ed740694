"""A case that a person wrote, in every form; what is none is told in one line."""

from __future__ import annotations

import pytest

from judge.data.given import line_of, read_case
from judge.errors import UsageError
from judge.problem.find import find_problem

CASE = (0, 0, 1, (-1, 1), (1.5, 1))


@pytest.fixture(scope="module")
def count():
    return find_problem("count")


@pytest.mark.parametrize(
    "text",
    [
        "0, 0, 1, (-1, 1), (1.5, 1)",
        " 0,0,1,[-1,1],(1.5,+1,) ",
        "cx=0, cy=0, r=1, A=(-1, 1), B=(1.5, 1)",
        "0, 0, B=(3/2, 1), A=(-1, 2**0), r=4 - 3",
        "line_count(0, 0, 1, (-1, 1), (1.5, 1))",
        "line_count(cx=0, cy=0, r=1, A=(-1, 1), B=(1.5, 1))",
        "0 0 1 -1 1 1.5 1",
        "0 0  1\t-1 1 1.5 1 ",
    ],
)
def test_a_case_in_every_form(count, text):
    found = read_case(count, text)
    assert repr(found) == repr(CASE)
    assert read_case(count, line_of(count, found)) == found


def test_ints_stay_ints_and_floats_floats(count):
    assert repr(read_case(count, "0 0.0 1 1e3 10 -0.0 1")) == repr((0, 0.0, 1, (1000.0, 10), (-0.0, 1)))
    assert repr(read_case(count, "10**9, 1e9, 1, (2**0.5, 1), (0, 0)")[:2]) == "(1000000000, 1000000000.0)"


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("", "it is empty"),
        ("0 0 1 -1 1 1.5", "the line ends before B is whole"),
        ("0 0 1", "the line ends before A is whole"),
        ("0 0 1 -1 1 1.5 1 7", "'7' is left over after B"),
        ("0 0 one -1 1 1.5 1", "'one' is no value of r, number"),
        ("0 0 nan -1 1 1.5 1", "'nan' is no value of r, number"),
        ("0, 0, 1, (-1, 1)", "B is missing"),
        ("0, 0", "r and A and B are missing"),
        ("0, 0, 1, (-1, 1), (1, 1), 9", "it has 6 arguments, not 5"),
        ("0, 0, 1, (-1, 1), r=1", "r is given twice"),
        ("0, 0, radius=1", "it has no parameter radius"),
        ("0, 0, b=(1, 1)", "it has no parameter b"),
        ("0, 0, **{'r': 1}", "it has no parameter **"),
        ("0, 0, (1", "it is no Python ("),
        ("0, 0) + (1", "it is no Python ("),
        ("0, 0, x, (1, 1), (2, 2)", "r: 'x' is no plain value"),
        ("0, 0, __import__('os').getpid(), (1, 1), (2, 2)", "is no plain value"),
        ("0, 0, 1/0, (1, 1), (2, 2)", "r: division by zero"),
        ("0, 0, 1e308*10, (1, 1), (2, 2)", "r: a number is not finite or not real"),
        ("0, 0, (-1)**0.5, (1, 1), (2, 2)", "r: a number is not finite or not real"),
        ("0, 0, 9**9**9, (1, 1), (2, 2)", "r: a power is too large"),
        ("0, 0, 10.0**400, (1, 1), (2, 2)", "r: "),
        ("0, 0, -'a', (1, 1), (2, 2)", "r: \"'a'\" is no number"),
        ("segment(0, 0)", "segment is not line_count"),
        ("(" * 5000, "it is no Python ("),
        ("0," * 10_001, "it has 20,002 characters"),
        ("[" * 60 + "1" + "]" * 60 + ",2", "cx: it is nested too deeply"),
    ],
)
def test_what_is_no_case_is_told_in_a_line(count, text, told):
    with pytest.raises(UsageError) as refused:
        read_case(count, text)
    said = str(refused.value)
    assert told in said
    assert said.startswith("this is no case of count: ")
    assert said.endswith("; write cx, cy, r, A, B as Python arguments, or a line as a program reads it")
    assert "\n" not in said


def test_an_odd_text_writes_no_warning(count, recwarn):
    with pytest.raises(UsageError):
        read_case(count, "0if 1else 2, '\\d'")
    assert list(recwarn) == []


def test_an_int_of_thousands_of_digits_is_no_traceback(count):
    with pytest.raises(UsageError, match="it is no Python"):
        read_case(count, "1" * 5000 + ", 0, 1, (0, 0), (1, 1)")
    with pytest.raises(UsageError, match="is no value of cx"):
        read_case(count, "1" * 5000 + " 0 1 0 0 1 1")
