"""Certified decimal text and errors in ulps, against python-flint."""

from __future__ import annotations

import math
import random
from fractions import Fraction

import pytest
from flint_support import any_parts, ball, bounds_as_fractions, decimal_exponent

from judge.exact import Surd, decimal_text


def test_decimal_text_agrees_with_flint():
    source = random.Random(13)
    for _ in range(600):
        parts = any_parts(source)
        surd = Surd(*parts)
        digits = source.randint(1, 40)
        text = surd.decimal(digits)
        written = Fraction(text)
        if surd == written:
            continue
        # Certified: |x − text| is at most half a unit of its last kept digit.
        exponent = decimal_exponent(abs(written))
        half = Fraction(10) ** (exponent - digits + 1) / 2
        assert written - half <= surd <= written + half, (parts, digits, text)
        flint_low, flint_high = bounds_as_fractions(ball(parts, 4000))
        assert written - half <= flint_high
        assert flint_low <= written + half
        kept = text.lstrip("-").split("e")[0].replace(".", "").lstrip("0")
        assert len(kept) == digits or (exponent >= 0 and kept.endswith("0"))


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        (Surd(0, 1, 2), 5, "1.4142"),
        (Surd(0, -1, 2), 30, "-1.41421356237309504880168872421"),
        (Surd(1, 0, 0, 2), 17, "0.5"),
        (Surd(0), 17, "0"),
        (Surd(2, 0, 0, 3), 4, "0.6667"),
        (Surd(5, 0, 0, 2), 1, "2"),  # a tie goes to even
        (Surd(99999, 0, 0, 10), 4, "10000"),
        (Surd(10**20), 17, "1e+20"),
        (Surd(1, 0, 0, 10**4), 17, "0.0001"),
        (Surd(1, 0, 0, 10**5), 17, "1e-05"),
        (Surd(10**30 + 1), 10, "1.000000000e+30"),
        (Surd(-(10**20), 1, 10**40 + 1), 5, "5.0000e-21"),
        (Surd(205, 0, 0, 100), 2, "2.0"),  # rounded, so that the zero is known and stays
    ],
)
def test_decimal_text_of_known_numbers(value, digits, text):
    assert value.decimal(digits) == text


def test_decimal_text_rereads_to_the_same_double():
    source = random.Random(17)
    for _ in range(500):
        surd = Surd(*any_parts(source))
        if math.isfinite(float(surd)) and abs(float(surd)) > 1e-300:
            assert float(surd.decimal(25)) == float(surd)


def test_decimal_text_of_doubles_is_their_repr_where_short():
    for value in (0.5, 1e22, 1e-05, 123456.789e3, 0.0001):
        assert float(decimal_text(value)) == value
    assert decimal_text(0.1, 20) == "0.10000000000000000555"
    with pytest.raises(ValueError, match="digits"):
        decimal_text(0.5, 0)


def test_ulp_is_that_of_the_exact_number():
    source = random.Random(19)
    for _ in range(600):
        parts = any_parts(source)
        surd = Surd(*parts)
        exponent = surd.ulp_exponent()
        assert surd.ulp() == Fraction(2) ** exponent
        low = Fraction(2) ** (exponent + 52)
        assert abs(surd) < 2 * low
        assert exponent >= -1074
        assert exponent == -1074 or abs(surd) >= low
    assert Surd(0).ulp() == Fraction(1, 2**1074)
    assert Surd(1, 0, 0, 2**1080).ulp() == Surd(-1, 0, 0, 2**1074).ulp() == Fraction(1, 2**1074)
    just_below_two = Surd(0, 1, 4 * 10**40 - 1, 10**20)
    assert float(just_below_two) == 2.0
    assert just_below_two.ulp() == Fraction(1, 2**52)
    assert Surd(2).ulp() == Fraction(1, 2**51)


def test_ulps_are_the_exact_error_correctly_rounded():
    source = random.Random(23)
    for _ in range(400):
        parts = any_parts(source)
        surd = Surd(*parts)
        near = float(surd)
        if not math.isfinite(near):
            continue
        answer = math.nextafter(near, source.choice((-math.inf, math.inf)))
        if math.isinf(answer):
            continue
        flint_low, flint_high = bounds_as_fractions(ball(parts, 5000))
        ends = [abs(Fraction(answer) - end) / surd.ulp() for end in (flint_low, flint_high)]
        assert surd.ulps(answer) in (float(ends[0]), float(ends[1]))
    assert Surd(3).ulps(3) == 0.0
    assert Surd(1).ulps(1 + 2**-52) == 1.0
    assert Surd(1).ulps(1 - 2**-53) == 0.5
    assert Surd(1).ulps(math.inf) == math.inf
    assert Surd(0).ulps(Fraction(1, 2**1075)) == 0.5
