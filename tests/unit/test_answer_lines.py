"""Program mode's lines: what is read, what is refused and why, and how an answer is rendered."""

from __future__ import annotations

from fractions import Fraction

import pytest

from judge.compare import Accepted, Rejection, check_line, compile_answer, render
from judge.compare.answers import Count, Parameter, Points
from judge.exact import Surd
from judge.problem import AnswerKind, Tolerance
from judge.topics.circles.line import CircleLine

TOLERANCE = Tolerance(relative=Fraction(1, 10**9), zero=Fraction(1, 10**12), ulps=Fraction(1))
LINE = CircleLine.through(2, 1, 1, (0, 1), (4, 1))
TWO = Points((LINE.point(-1), LINE.point(1)), LINE.extent_length())
KINDS = {Count: AnswerKind.COUNT, Points: AnswerKind.POINTS, Parameter: AnswerKind.PARAMETER}


def judge(line, answer):
    target = compile_answer(answer, TOLERANCE)
    return check_line(KINDS[type(answer)], line, target, lambda: (answer, TOLERANCE))


@pytest.mark.parametrize(
    ("line", "answer"),
    [
        ("1", Count(1)),
        ("  2 ", Count(2)),
        ("\t0\r", Count(0)),
        ("+1", Count(1)),
        ("01", Count(1)),
        ("none", Count(None)),
        ("0", Points((), Surd(1))),
        ("2 1 1 3 1", TWO),
        ("2 1.0 1.0000000000 3e0 10E-1", TWO),
        ("2 +1.0 1 0.3e+1 1", TWO),
        ("2 1.000000001 1 3 1", TWO),
        ("0.5", Parameter(Surd(1, 0, 0, 2), Surd(1))),
        ("none", Parameter(None, Surd(1))),
        ("0", Parameter(Surd(0), Surd(1))),
        ("-0.0", Parameter(Surd(0), Surd(1))),
        ("1e-12", Parameter(Surd(0), Surd(1))),
        ("1.41421356237", Parameter(Surd(0, 1, 2), Surd(1))),
    ],
)
def test_accepted(line, answer):
    assert isinstance(judge(line, answer), Accepted)


@pytest.mark.parametrize(
    ("line", "answer", "message"),
    [
        ("2", Count(1), "1 wanted, 2 given"),
        ("2", Count(None), "none wanted, 2 given"),
        ("none", Count(1), "1 wanted, none given"),
        ("1.0", Count(1), '"1.0" where 0, 1, 2 or none is meant: write a plain integer'),
        ("0.9999999", Count(1), "write a plain integer"),
        ("None", Count(None), "write none in lower case"),
        ("1_0", Count(1), "write a plain integer"),
        ("0x1", Count(1), "write a plain integer"),
        ("", Count(1), "an empty line"),
        ("   ", Count(1), "an empty line"),
        ("1 point", Count(1), '"point" after the answer'),
        ("1\0", Count(1), "a NUL in the output"),
        ("１", Count(1), "the character '\\uff11' in the output"),
        ("1\x1b[2J", Count(1), "the character '\\x1b' in the output"),
        ("1\u00a0", Count(1), "the character '\\xa0' in the output"),
        ("9" * 5000, Count(1), "write a plain integer"),
        ("9007199254740993", Count(1), "1 wanted, 9007199254740993 given"),
        ("2 1 1 3", TWO, "k = 2 needs 4 coordinates, 3 given"),
        ("2 1 1 3 1 7", TWO, "k = 2 needs 4 coordinates, 5 given"),
        ("1 1 1", TWO, "2 points wanted, 1 given"),
        ("2 3 1 1 1", TWO, "the right points in the wrong order"),
        ("3 1 1 3 1 5 1", TWO, "0, 1 or 2 points in common"),
        ("-1", TWO, "0, 1 or 2 points in common"),
        ("none", TWO, "no points are 0"),
        ("2.0 1 1 3 1", TWO, "write a plain integer"),
        ("2 1 1 nan 1", TWO, '"nan" where a coordinate is meant: it is not a finite number'),
        ("2 1 1 inf 1", TWO, "it is not a finite number"),
        ("2 1 1 3_0 1", TWO, "it has an underscore"),
        ("2 1 1 0x3 1", TWO, "it is hexadecimal"),
        ("2 1 1 0x1.8p1 1", TWO, "it is hexadecimal"),
        ("2 1 1 3, 1", TWO, "it is not a plain decimal number"),
        ("2 1 1 .3 1", TWO, "it is not a plain decimal number"),
        ("2 1 1 3. 1", TWO, "it is not a plain decimal number"),
        ("2 1 1 3e 1", TWO, "it is not a plain decimal number"),
        ("2 1 1 1e999999999 1", TWO, "its exponent is beyond"),
        ("2 1 1 1e-99999999999999999999 1", TWO, "its exponent is beyond"),
        ("2 1 1 " + "3" * 5000 + " 1", TWO, "a number of 5000 characters"),
        ("2 1 1 1e99999 1", TWO, "its exponent is beyond"),
        ("2 1 1 1e-5001 1", TWO, "its exponent is beyond"),
        ("2 1 1 1e5000 1", TWO, "x of point 2 is off by inf"),
        ("2 1 1 1e-5000 1", TWO, "x of point 2 is off by 3"),
        ("0.5000001", Parameter(Surd(1, 0, 0, 2), Surd(1)), "t is off by 1e-07"),
        ("none", Parameter(Surd(1), Surd(1)), "none given, but the ray hits: t = 1.0"),
        ("3", Parameter(None, Surd(1)), "none wanted, 3 given"),
        ("-1", Parameter(None, Surd(1)), "none wanted, -1 given"),
    ],
)
def test_refused(line, answer, message):
    outcome = judge(line, answer)
    assert isinstance(outcome, Rejection)
    assert message in outcome.message
    assert outcome.wanted == render(KINDS[type(answer)], answer)
    assert outcome.got.isprintable()
    assert len(outcome.message) + len(outcome.got) < 400


def test_decimals_are_decided_as_written_not_as_doubles():
    """With a tolerance of one ulp about an integer, the 40th digit decides."""
    answer = Parameter(Surd(2), Surd(1))
    exact = Tolerance(ulps=Fraction(1))
    target = compile_answer(answer, exact)

    def accepted(line):
        outcome = check_line(AnswerKind.PARAMETER, line, target, lambda: (answer, exact))
        return isinstance(outcome, Accepted)

    edge = "2.0000000000000004440892098500626161694526672363281250"
    assert Fraction(edge) == 2 + Fraction(1, 2**51)
    assert accepted(edge)
    assert accepted(edge[:-1])
    assert not accepted(edge + "00001")
    assert not accepted("2.00000000000000044408920985006262")
    assert float("2.00000000000000044408920985006262") == 2 + 2**-51


@pytest.mark.parametrize(
    ("answer", "line"),
    [
        (Count(None), "none"),
        (Count(2), "2"),
        (Points((), Surd(1)), "0"),
        (TWO, "2 1.0 1.0 3.0 1.0"),
        (Parameter(None, Surd(1)), "none"),
        (Parameter(Surd(0, 1, 2), Surd(1)), "1.4142135623730951"),
    ],
)
def test_render_prints_what_a_perfect_program_prints(answer, line):
    kind = KINDS[type(answer)]
    target = compile_answer(answer, TOLERANCE)
    assert render(kind, answer) == render(kind, target) == line
    assert isinstance(judge(line, answer), Accepted)
    with pytest.raises(TypeError):
        render(next(other for other in AnswerKind if other is not kind), answer)
