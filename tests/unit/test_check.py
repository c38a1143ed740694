"""What `check` says of right, wrong, mistyped and forged answers."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from judge.exact import Surd
from judge.topics.circles.line import CircleLine
from judge.values import Accepted, Real, Rejection, Tolerance, Words, parse, vector

POINTS_TOLERANCE = Tolerance(extent=Fraction(1, 10**9), ulps=Fraction(4))
T_TOLERANCE = Tolerance(relative=Fraction(1, 10**9), zero=Fraction(1, 10**12))
LINE = CircleLine.through(2, 1, 1, (0, 1), (4, 1))
TWO = [vector(LINE.point(which), LINE.extent_length()) for which in (-1, 1)]
ONE = [vector(CircleLine.through(2, 1, 1, (3, 0), (3, 3)).point(0), 2)]
NONE = []
POINTS = parse("points", words=Words(order="they come in the order of t along the line"))
COUNT = parse("count", words=Words(meant="0, 1, 2 or none"))
PARAMETER = parse("parameter", words=Words(answer="t", missing="but the ray hits"))


def never():
    raise AssertionError("the exact answer was asked for without need")


def points(raw: Any, answer: Any = TWO):
    return POINTS.check(raw, POINTS.target(answer, POINTS_TOLERANCE), lambda: (answer, POINTS_TOLERANCE))


def count(raw: Any, value: int | None = 1):
    return COUNT.check(raw, COUNT.target(value, T_TOLERANCE), never)


def parameter(raw: Any, t: Surd | None = Surd(1, 0, 0, 2)):  # noqa: B008  # immutable
    answer = None if t is None else Real(t, 2)
    return PARAMETER.check(raw, PARAMETER.target(answer, T_TOLERANCE), lambda: (answer, T_TOLERANCE))


def test_worst_error_is_measured_in_ulps():
    assert points([[1.0, 1.0], [3.0, 1.0]]) == Accepted(0.0)
    assert points([[1.0, 1.0], [3.0 + 2**-50, 1.0]]) == Accepted(2.0)
    assert points([[1.0, 1], [3.0 + 2**-50, 1.0]]) == Accepted(2.0)
    assert points([], NONE) == Accepted(None)
    assert count(1) == Accepted(None)
    assert parameter(0.5 + 2**-52) == Accepted(2.0)
    assert parameter(0.0, Surd(0)) == Accepted(0.0)
    assert parameter(1e-13, Surd(0)) == Accepted(0.0)
    assert parameter(None, None) == Accepted(None)
    # x just below 2, whose double is 2: the ulp is that of the exact number, not of its double.
    below = Surd(0, 1, 4 * 10**40 - 1, 10**20)
    assert parameter(2.0, below).worst_ulps == pytest.approx(0.0, abs=1e-9)
    assert parameter(2.0 - 2**-52, below).worst_ulps == pytest.approx(1.0)
    assert parameter(2, below).worst_ulps == pytest.approx(0.0, abs=1e-9)


def test_a_number_that_is_off_is_named_and_measured():
    outcome = points([[1.0, 1.0], [3.0, 1.5]])
    assert isinstance(outcome, Rejection)
    assert outcome.where == "y of point 2"
    assert (outcome.absolute, outcome.relative, outcome.ulps) == (0.5, 0.5, 0.5 * 2**52)
    assert outcome.message == "y of point 2 is off by 0.5, relative error 0.5 (2.25e+15 ulps)"
    assert outcome.got == "[(1.0, 1.0), (3.0, 1.5)]"


def test_a_tangency_given_twice_is_named():
    outcome = points([[3.0, 1.0], [3.0, 1.0]], ONE)
    assert outcome.message == "1 point wanted, 2 given: the same point twice"
    assert points([[3.0, 1.0], [4.0, 1.0]], ONE).message == "1 point wanted, 2 given"
    assert points([[3.0, 1.0]], NONE).message == "no points wanted, 1 given"


@pytest.mark.parametrize(
    ("raw", "message"),
    [
        (2, "1 wanted, 2 given"),
        (1.0, "the float 1.0 where an int is meant"),
        (True, "the bool True where an int is meant"),
        ({"type": "bool_", "text": "True"}, "the bool_ True where an int is meant"),
        ({"int": "10000000000000000"}, "1 wanted, 18446744073709551616 given"),
        ({"fraction": ["1", "1"]}, "the number Fraction(1, 1) where an int is meant"),
        ({"type": "Colour", "text": "a subclass of int"}, "Colour, a subclass of int, where an int is meant"),
    ],
)
def test_wrong_counts_say_why(raw, message):
    outcome = count(raw)
    assert isinstance(outcome, Rejection)
    assert outcome.message.startswith(message)
    assert isinstance(count(None, None), Accepted)
    assert count(0, None).message == "None wanted, 0 given"


def deep(levels: int) -> Any:
    value: Any = 1.0
    for _ in range(levels):
        value = [value]
    return value


ABSURD = [
    deep(100_000), [[1.0] * 100_000] * 2, [[]] * 2, [{}, {}], {}, {1: 2}, {1, 2}, object(), b"bytes",
    True, False, {"type": 1, "text": []}, {"type": "x" * 10**6, "text": "\x1b[2J" * 10**5}, {"type": "bool"},
    {"int": 5}, {"int": "zz"}, {"int": "f" * 10**6}, {"int": "-"},
    {"fraction": ["1", "0"]}, {"fraction": ["1"]}, {"fraction": "ab"}, {"fraction": [["1"], {}]},
    {"fraction": ["f" * 1000, "1"]}, {"fraction": ["1", "f" * 1000]},
    {"decimal": "1e999999999"}, {"decimal": "1e-999999999999999999999999999"}, {"decimal": "9" * 10**6},
    {"decimal": "nan"}, {"decimal": ["1"]}, {"decimal": "１"}, {"decimal": "1e5000"}, {"decimal": "1e-5000"},
    float("inf"), float("-inf"), float("nan"), 10**3000, -(10**3000), 1e308, -5e-324,
    "text" * 10**5, "\x00\x1b[31m", [None, None], [[None, None], [None, None]], [["1", "1"], ["3", "1"]],
    [{"type": "list", "text": ""}, [1, 1]], [[1e308, 1e308], [-1e308, {"int": "-f" * 3}]],
]  # fmt: skip


@pytest.mark.parametrize("raw", ABSURD, ids=range(len(ABSURD)))
def test_absurd_answers_are_rejected_and_never_raise(raw):
    for form in (raw, [raw], [[raw, raw], [raw, raw]], [[1.0, raw], [3.0, 1.0]]):
        for outcome in (points(form), points(form, ONE), count(form), parameter(form)):
            assert isinstance(outcome, Rejection)
            for text in (outcome.message, outcome.got, outcome.wanted):
                assert len(text) < 800
                assert text.isprintable()
