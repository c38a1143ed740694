"""Answers as lines and as values: what is read, what is refused and why, digits that were cut off."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from judge.exact import Surd
from judge.languages.shapes import shape_of
from judge.values import answers, check, show, wire
from judge.values.answers import Real, Tolerance, Words, vector
from judge.values.check import Accepted, Rejection
from judge.values.grammar import TypeFault, parse

TOLERANCE = Tolerance(relative=Fraction(1, 10**9), zero=Fraction(1, 10**12), ulps=Fraction(1))
TWO = ("points", [vector((1, 1), 2), vector((3, 1), 2)])
WORDS = {
    "count": Words(meant="0, 1, 2 or none"),
    "points": Words(order="they come in the order of t along the line"),
    "parameter": Words(answer="t", missing="but the ray hits"),
}


def count(value):
    return "count", value


def parameter(t, unit=1):
    return "parameter", None if t is None else Real(t, unit)


def judge(line, answer):
    text, exact = answer
    type_ = parse(text, words=WORDS.get(text, Words()))
    return check.check_line(type_, line, check.target(type_, exact, TOLERANCE), lambda: (exact, TOLERANCE))


def render(answer):
    text, exact = answer
    return show.line(parse(text), check.target(parse(text), exact, TOLERANCE))


@pytest.mark.parametrize(
    ("line", "answer"),
    [
        ("1", count(1)),
        ("  2 ", count(2)),
        ("none", count(None)),
        ("0", ("points", [])),
        ("2 1.0 1.0000000000 3e0 10E-1", TWO),
        ("2 1.000000001 1 3 1", TWO),
        ("2 1. +1 .3e1 1.E+00", TWO),
        ("0.5", parameter(Surd(1, 0, 0, 2), 1)),
        (".5", parameter(Surd(1, 0, 0, 2), 1)),
        ("-.5", parameter(Surd(-1, 0, 0, 2), 1)),
        ("none", parameter(None, 1)),
        ("-0.0", parameter(Surd(0), 1)),
        ("1e-12", parameter(Surd(0), 1)),
        ("1.41421356237", parameter(Surd(0, 1, 2), 1)),
    ],
)
def test_accepted(line, answer):
    assert isinstance(judge(line, answer), Accepted)


@pytest.mark.parametrize(
    ("line", "answer", "message"),
    [
        ("2", count(1), "1 expected, 2 given"),
        ("2", count(None), "none expected, 2 given"),
        ("1.", count(1), '"1." where 0, 1, 2 or none is expected: write a plain integer'),
        ("1.0", count(1), '"1.0" where 0, 1, 2 or none is expected: write a plain integer'),
        ("None", count(None), "write none in lower case"),
        ("0x1", count(1), "write a plain integer"),
        ("", count(1), "an empty line"),
        ("1 point", count(1), '"point" after the answer'),
        ("1\0", count(1), "'\\x00' (U+0000) in the output"),
        ("１", count(1), "'１' (U+FF11) in the output"),
        ("1\u00a0", count(1), "'\\xa0' (U+00A0) in the output"),
        ("9" * 5000, count(1), "write a plain integer"),
        ("9007199254740993", count(1), "1 expected, 9007199254740993 given"),
        ("2 1 1 3", TWO, "k = 2 needs 4 coordinates, 3 given"),
        ("2 1 1 3 1 7", TWO, "k = 2 needs 4 coordinates, 5 given"),
        ("2 3 1 1 1", TWO, "the right points in the wrong order"),
        ("3 1 1 3 1 5 1", TWO, "where 0 to 2 points are expected"),
        ("-1", TWO, "where 0 to 2 points are expected"),
        ("none", TWO, "no points are 0"),
        ("2 1 1 nan 1", TWO, '"nan" where a coordinate is expected: it is not a finite number'),
        ("2 1 1 3_0 1", TWO, "it has an underscore"),
        ("2 1 1 0x1.8p1 1", TWO, "it is hexadecimal"),
        ("2 1 1 . 1", TWO, "it is not a plain decimal number"),
        ("2 1 1 .e1 1", TWO, "it is not a plain decimal number"),
        ("2 1 1 3.. 1", TWO, "it is not a plain decimal number"),
        ("2 1 1 1e999999999 1", TWO, "its exponent is beyond"),
        ("2 1 1 " + "3" * 5000 + " 1", TWO, "a number of 5000 characters"),
        ("2 1 1 1e99999 1", TWO, "its exponent is beyond"),
        ("2 1 1 1e5000 1", TWO, "x of point 2 is off by inf"),
        ("none", parameter(Surd(1), 1), "none given, but the ray hits: t = 1.0"),
        ("3", parameter(None, 1), "none expected, 3 given"),
        ("-1", parameter(None, 1), "none expected, -1 given"),
    ],
)
def test_refused(line, answer, message):
    outcome = judge(line, answer)
    assert isinstance(outcome, Rejection)
    assert message in outcome.message
    assert outcome.wanted == render(answer)
    assert outcome.got.isprintable()
    assert len(outcome.message) + len(outcome.got) < 400


def test_decimals_are_decided_as_written_not_as_doubles():
    """With a tolerance of one ulp about an integer, the 40th digit decides."""
    type_, answer = parse("real"), Real(Surd(2), 1)
    exact = Tolerance(ulps=Fraction(1))
    target = check.target(type_, answer, exact)

    def accepted(line):
        return isinstance(check.check_line(type_, line, target, lambda: (answer, exact)), Accepted)

    edge = "2.0000000000000004440892098500626161694526672363281250"
    assert Fraction(edge) == 2 + Fraction(1, 2**51)
    assert accepted(edge)
    assert accepted(edge[:-1])
    assert not accepted(edge + "00001")
    assert not accepted("2.00000000000000044408920985006262")
    assert accepted(f".{edge.replace('.', '')}e1")
    assert not accepted(f".{edge.replace('.', '')}00001e1")
    assert accepted(f"{edge.replace('.', '')}.e-52")
    assert float("2.00000000000000044408920985006262") == 2 + 2**-51


ROOT_2 = Surd(0, 1, 2, 1)


@pytest.mark.parametrize(
    ("text", "nearest"),
    [
        ("141421356.237310", 2**0.5 * 1e8),  # which has six decimals by chance
        ("-100000008.307692", -100000008.30769231),
        ("1.4142135623731", 2**0.5),  # the last digit is 0, and is left out
    ],
)
def test_as_many_digits_as_a_double_keeps_are_not_six_decimals(text, nearest):
    told = answers.cut_digits(wire.Written(text, float(text)), nearest)
    assert told == "printed with 15 significant digits: print 17"
    assert answers.is_cut(f"x is off by 1e-7; {told}")


def why(line, x):
    found = judge(line, ("real", Real(x, 1)))
    assert isinstance(found, Rejection)
    return found.message


@pytest.mark.parametrize(
    ("line", "x", "how"),
    [
        ("1.41421", ROOT_2, "6 significant digits: print 17"),
        ("-1.41421", -ROOT_2, "6 significant digits: print 17"),
        ("1.414214", ROOT_2, "6 decimals: print 17 significant digits"),
        ("0.000480", Fraction(4801, 10**7), "6 decimals: print 17 significant digits"),
        ("0.000000", Fraction(4801, 10**12), "6 decimals: print 17 significant digits"),
        ("1.41421e+10", ROOT_2 * 10**10, "6 significant digits: print 17"),
        (
            "0.12346",
            Fraction(123460004, 10**9),
            "6 significant digits: print 17",
        ),  # a stream leaves out the 0
    ],
)
def test_a_rounded_decimal_is_told_how_many_digits_it_has(line, x, how):
    assert why(line, x).endswith(f"; printed with {how}")


@pytest.mark.parametrize(
    ("line", "x"),
    [
        ("1.41422", ROOT_2),  # the last digit is another one
        ("1.4", ROOT_2),  # two digits may be a coincidence
        ("1", ROOT_2),
        ("1.414214562373095", ROOT_2),
        ("1.4142135723730951", ROOT_2),  # all digits are there
        ("0.5", Fraction(50001, 10**5)),  # as Python prints one half
    ],
)
def test_another_number_is_not_called_rounded(line, x):
    assert "printed with" not in why(line, x)


def test_the_parts_of_a_tuple_have_the_names_that_a_kata_gives_them():
    right = tuple(Real(Fraction(x), 1) for x in (1, 2, 5))
    for text, parts, where in (("vec3?", "a, b, c", "c"), ("(real, vec2)?", "t, F", "y of F")):
        type_ = parse(text, words=Words(parts=parts))
        answer = right if text == "vec3?" else (right[0], right[1:])
        given = [1, 2, 6] if text == "vec3?" else [1, [2, 6]]
        target = check.target(type_, answer, TOLERANCE)
        found = check.check(type_, given, target, lambda: (answer, TOLERANCE))  # noqa: B023
        assert found.message.startswith(f"{where} is off by")
        assert shape_of(type_) == shape_of(parse(text))  # files of other languages are as they were
    with pytest.raises(TypeFault, match="has no 2 parts"):
        parse("vec3", words=Words(parts="a, b"))


@pytest.mark.parametrize("line", ["1,41421", "-3,5", "2,5e3"])
def test_a_decimal_comma_is_told(line):
    assert why(line, ROOT_2) == f'"{line}" where a number is expected: it has a decimal comma; write a point'


POINTS_TOLERANCE = Tolerance(extent=Fraction(1, 10**9), ulps=Fraction(4))
T_TOLERANCE = Tolerance(relative=Fraction(1, 10**9), zero=Fraction(1, 10**12))
ONE = [vector((3, 1), 2)]
POINTS = parse("points", words=WORDS["points"])
COUNT = parse("count", words=WORDS["count"])
PARAMETER = parse("parameter", words=WORDS["parameter"])


def never():
    raise AssertionError("the exact answer was asked for without need")


def points_of(raw: Any, answer: Any = TWO[1]):
    return check.check(
        POINTS, raw, check.target(POINTS, answer, POINTS_TOLERANCE), lambda: (answer, POINTS_TOLERANCE)
    )


def count_of(raw: Any, value: int | None = 1):
    return check.check(COUNT, raw, check.target(COUNT, value, T_TOLERANCE), never)


def parameter_of(raw: Any, t: Surd | None = Surd(1, 0, 0, 2)):  # noqa: B008  # immutable
    answer = None if t is None else Real(t, 2)
    return check.check(
        PARAMETER, raw, check.target(PARAMETER, answer, T_TOLERANCE), lambda: (answer, T_TOLERANCE)
    )


def test_worst_error_is_measured_in_ulps():
    assert points_of([[1.0, 1.0], [3.0, 1.0]]) == Accepted(0.0)
    assert points_of([[1.0, 1.0], [3.0 + 2**-50, 1.0]]) == Accepted(2.0)
    assert points_of([[1.0, 1], [3.0 + 2**-50, 1.0]]) == Accepted(2.0)
    assert points_of([], []) == Accepted(None)
    assert count_of(1) == Accepted(None)
    assert parameter_of(0.5 + 2**-52) == Accepted(2.0)
    assert parameter_of(0.0, Surd(0)) == Accepted(0.0)
    assert parameter_of(1e-13, Surd(0)) == Accepted(0.0)
    assert parameter_of(None, None) == Accepted(None)
    # x just below 2, whose nearest double is 2: it is that double's ulp that is counted in.
    below = Surd(0, 1, 4 * 10**40 - 1, 10**20)
    assert parameter_of(2.0, below).worst_ulps == 0.0
    assert parameter_of(2.0 - 2**-52, below).worst_ulps == 0.5
    assert parameter_of(2, below).worst_ulps == 0.0


def test_a_number_that_is_off_is_named_and_measured():
    outcome = points_of([[1.0, 1.0], [3.0, 1.5]])
    assert isinstance(outcome, Rejection)
    assert outcome.where == "y of point 2"
    assert (outcome.absolute, outcome.relative, outcome.ulps) == (0.5, 0.5, 0.5 * 2**52)
    assert outcome.message == "y of point 2 is off by 0.5, relative error 0.5"
    assert outcome.got == "[(1.0, 1.0), (3.0, 1.5)]"


def test_a_tangency_given_twice_is_named():
    outcome = points_of([[3.0, 1.0], [3.0, 1.0]], ONE)
    assert outcome.message == "1 point expected, 2 given: the same point twice"
    assert points_of([[3.0, 1.0], [4.0, 1.0]], ONE).message == "1 point expected, 2 given"
    assert points_of([[3.0, 1.0]], []).message == "no points expected, 1 given"


@pytest.mark.parametrize(
    ("raw", "message"),
    [
        (2, "1 expected, 2 given"),
        (1.0, "the float 1.0 where an int is expected"),
        (True, "the bool True where an int is expected"),
        ({"type": "bool_", "text": "True"}, "the bool_ True where an int is expected"),
        ({"int": "10000000000000000"}, "1 expected, 18446744073709551616 given"),
        ({"fraction": ["1", "1"]}, "the number Fraction(1, 1) where an int is expected"),
        (
            {"type": "Colour", "text": "a subclass of int"},
            "Colour, a subclass of int, where an int is expected",
        ),
    ],
)
def test_wrong_counts_say_why(raw, message):
    outcome = count_of(raw)
    assert isinstance(outcome, Rejection)
    assert outcome.message.startswith(message)
    assert isinstance(count_of(None, None), Accepted)
    assert count_of(0, None).message == "None expected, 0 given"


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
        for outcome in (points_of(form), points_of(form, ONE), count_of(form), parameter_of(form)):
            assert isinstance(outcome, Rejection)
            for text in (outcome.message, outcome.got, outcome.wanted):
                assert len(text) < 800
                assert text.isprintable()
