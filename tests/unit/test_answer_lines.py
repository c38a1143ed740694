"""Program mode's lines: what is read, what is refused and why, digits that were cut off, what is rendered."""

from __future__ import annotations

from fractions import Fraction

import pytest

from judge.exact import Surd
from judge.topics.circles.line import CircleLine
from judge.values import Accepted, Real, Rejection, Tolerance, Words, parse, vector

TOLERANCE = Tolerance(relative=Fraction(1, 10**9), zero=Fraction(1, 10**12), ulps=Fraction(1))
LINE = CircleLine.through(2, 1, 1, (0, 1), (4, 1))
TWO = ("points", [vector(LINE.point(which), LINE.extent_length()) for which in (-1, 1)])
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
    return type_.check_line(line, type_.target(exact, TOLERANCE), lambda: (exact, TOLERANCE))


def render(answer):
    text, exact = answer
    return parse(text).line(parse(text).target(exact, TOLERANCE))


@pytest.mark.parametrize(
    ("line", "answer"),
    [
        ("1", count(1)),
        ("  2 ", count(2)),
        ("none", count(None)),
        ("0", ("points", [])),
        ("2 1.0 1.0000000000 3e0 10E-1", TWO),
        ("2 1.000000001 1 3 1", TWO),
        ("0.5", parameter(Surd(1, 0, 0, 2), 1)),
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
        ("2", count(1), "1 wanted, 2 given"),
        ("2", count(None), "none wanted, 2 given"),
        ("1.0", count(1), '"1.0" where 0, 1, 2 or none is meant: write a plain integer'),
        ("None", count(None), "write none in lower case"),
        ("0x1", count(1), "write a plain integer"),
        ("", count(1), "an empty line"),
        ("1 point", count(1), '"point" after the answer'),
        ("1\0", count(1), "a NUL in the output"),
        ("１", count(1), "the character '\\uff11' in the output"),
        ("1\u00a0", count(1), "the character '\\xa0' in the output"),
        ("9" * 5000, count(1), "write a plain integer"),
        ("9007199254740993", count(1), "1 wanted, 9007199254740993 given"),
        ("2 1 1 3", TWO, "k = 2 needs 4 coordinates, 3 given"),
        ("2 1 1 3 1 7", TWO, "k = 2 needs 4 coordinates, 5 given"),
        ("2 3 1 1 1", TWO, "the right points in the wrong order"),
        ("3 1 1 3 1 5 1", TWO, "where 0 to 2 points are meant"),
        ("-1", TWO, "where 0 to 2 points are meant"),
        ("none", TWO, "no points are 0"),
        ("2 1 1 nan 1", TWO, '"nan" where a coordinate is meant: it is not a finite number'),
        ("2 1 1 3_0 1", TWO, "it has an underscore"),
        ("2 1 1 0x1.8p1 1", TWO, "it is hexadecimal"),
        ("2 1 1 .3 1", TWO, "it is not a plain decimal number"),
        ("2 1 1 3. 1", TWO, "it is not a plain decimal number"),
        ("2 1 1 1e999999999 1", TWO, "its exponent is beyond"),
        ("2 1 1 " + "3" * 5000 + " 1", TWO, "a number of 5000 characters"),
        ("2 1 1 1e99999 1", TWO, "its exponent is beyond"),
        ("2 1 1 1e5000 1", TWO, "x of point 2 is off by inf"),
        ("none", parameter(Surd(1), 1), "none given, but the ray hits: t = 1.0"),
        ("3", parameter(None, 1), "none wanted, 3 given"),
        ("-1", parameter(None, 1), "none wanted, -1 given"),
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
    target = type_.target(answer, exact)

    def accepted(line):
        return isinstance(type_.check_line(line, target, lambda: (answer, exact)), Accepted)

    edge = "2.0000000000000004440892098500626161694526672363281250"
    assert Fraction(edge) == 2 + Fraction(1, 2**51)
    assert accepted(edge)
    assert accepted(edge[:-1])
    assert not accepted(edge + "00001")
    assert not accepted("2.00000000000000044408920985006262")
    assert float("2.00000000000000044408920985006262") == 2 + 2**-51


# -- digits that were left out -------------------------------------------------------------------------------

ROOT_2 = Surd(0, 1, 2, 1)


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


@pytest.mark.parametrize("line", ["1,41421", "-3,5", "2,5e3"])
def test_a_decimal_comma_is_told(line):
    assert why(line, ROOT_2) == f'"{line}" where a number is meant: it has a decimal comma; write a point'
