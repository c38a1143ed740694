"""Decimals that are right but for the digits that were left out, and decimals that are not."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

import pytest

from judge.exact import Surd
from judge.values import Real, Rejection, Tolerance, parse

TOLERANCE = Tolerance(relative=Fraction(1, 10**9), zero=Fraction(1, 10**12), ulps=Fraction(1))
ROOT_2 = Surd(0, 1, 2, 1)


def why(line, x):
    type_ = parse("real")
    exact = Real(x, 1)
    found = type_.check_line(line, type_.target(exact, TOLERANCE), lambda: (exact, TOLERANCE))
    assert isinstance(found, Rejection)
    return found.message


@pytest.mark.parametrize(
    ("line", "x", "how"),
    [
        ("1.41421", ROOT_2, "6 significant digits: print 17"),
        ("-1.41421", -ROOT_2, "6 significant digits: print 17"),
        ("1.414", ROOT_2, "4 significant digits: print 17"),
        ("1.4142136", ROOT_2, "8 significant digits: print 17"),
        ("1.414214", ROOT_2, "6 decimals: print 17 significant digits"),
        ("141.421356", ROOT_2 * 100, "6 decimals: print 17 significant digits"),
        ("0.000480", Fraction(4801, 10**7), "6 decimals: print 17 significant digits"),
        ("0.000000", Fraction(4801, 10**12), "6 decimals: print 17 significant digits"),
        ("1.41421e+10", ROOT_2 * 10**10, "6 significant digits: print 17"),
        ("141421", ROOT_2 * 10**5, "6 significant digits: print 17"),
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
        ("1.415", ROOT_2),
        ("1.4", ROOT_2),  # two digits may be a coincidence
        ("1", ROOT_2),
        ("-1.41421", ROOT_2),
        ("1.414214562373095", ROOT_2),
        ("1.4142135723730951", ROOT_2),  # all digits are there
        ("0.5", Fraction(50001, 10**5)),  # as Python prints one half
        ("0.0", Fraction(1, 10**6)),
    ],
)
def test_another_number_is_not_called_rounded(line, x):
    assert "printed with" not in why(line, x)


def test_every_rounding_of_a_number_is_seen_from_four_digits_on():
    x = Surd(1, 3, 7, 11)
    text = Decimal(x.decimal(40))
    for digits in range(4, 8):  # eight are within the tolerance
        line = f"{text:.{digits}g}"
        assert f"printed with {digits} significant" in why(line, x)


@pytest.mark.parametrize("line", ["1,41421", "-3,5", "2,5e3"])
def test_a_decimal_comma_is_told(line):
    assert why(line, ROOT_2) == f'"{line}" where a number is meant: it has a decimal comma; write a point'
