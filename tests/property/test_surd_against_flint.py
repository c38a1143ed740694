"""Surd against python-flint: signs, order, rounding, certified decimal text, errors in ulps."""

from __future__ import annotations

import math
import random
from decimal import Decimal
from fractions import Fraction

import flint
import pytest
from flint_support import (
    any_parts,
    ball,
    big,
    bounds_as_fractions,
    decimal_exponent,
    oracle,
    sign_of,
)
from sampling import nightly

from judge.exact import Surd
from judge.exact.signs import root_sign, two_root_sign


@pytest.mark.parametrize("count", [2000, nightly(30_000)])
def test_rounding_of_mixed_sizes_agrees_with_flint(count):
    source = random.Random(20261 + count)
    for _ in range(count):
        parts = any_parts(source)
        surd = Surd(*parts)
        assert (surd.round_down(), float(surd), surd.round_up()) == oracle(parts), parts


def test_signs_agree_with_flint():
    source = random.Random(3)
    for _ in range(2000):
        p, q, d, _ = any_parts(source)
        u, e = big(source, 100), abs(big(source, 100))
        if source.random() < 0.3:  # a near tie with the second root
            u = -math.isqrt((p * p + q * q * d) // (e or 1))
        assert root_sign(p, q, d) == sign_of(
            lambda precision, p=p, q=q, d=d: ball((p, q, d, 1), precision),
            lambda p=p, q=q, d=d: p * p == q * q * d,
        )
        wanted = sign_of(
            lambda precision, p=p, q=q, d=d, u=u, e=e: (
                ball((p, q, d, 1), precision) + flint.arb(u) * flint.arb(e).sqrt()
            ),
            lambda p=p, q=q, d=d, u=u, e=e: two_root_sign(-p, -q, d, -u, e) == 0,
        )
        assert two_root_sign(p, q, d, u, e) == wanted, (p, q, d, u, e)


def test_exactly_vanishing_sums_are_zero():
    source = random.Random(5)
    for _ in range(500):
        d, m, n, k = (source.randint(2, 10**12) for _ in range(4))
        # m√(d·n²) = m·n·√d, and k·√(d·m²) cancels it for any split.
        assert two_root_sign(0, m, d * n * n, -n, d * m * m) == 0
        assert two_root_sign(k, m, d, -1, m * m * d) == 1
        assert two_root_sign(-k, m, d, -1, m * m * d) == -1
        assert Surd(k, m, d * n * n, 7) == Surd(k, m * n, d, 7)
        assert hash(Surd(k, m, d * n * n, 7)) == hash(Surd(k, m * n, d, 7))


def test_order_of_different_radicands_agrees_with_flint():
    source = random.Random(11)
    for _ in range(700):
        mine = any_parts(source)
        its = any_parts(source)
        if source.random() < 0.3:  # a neighbour: the same number up to one part in a very large denominator
            p, q, d, s = mine
            its = p * 10**30 + source.choice((-1, 0, 1)), q * 10**15, d * 10**30, s * 10**30
        x, y = Surd(*mine), Surd(*its)
        wanted = sign_of(
            lambda precision, mine=mine, its=its: ball(mine, precision) - ball(its, precision),
            lambda x=x, y=y: x.compare(y) == 0,
        )
        assert x.compare(y) == wanted
        assert y.compare(x) == -wanted
        said = (x < y, x <= y, x == y, x >= y, x > y)
        assert said == (wanted < 0, wanted <= 0, wanted == 0, wanted >= 0, wanted > 0)


def test_order_against_python_numbers():
    root = Surd(0, 1, 2)
    near = float(root)
    assert (root > near) == (Fraction(near) ** 2 < 2)
    assert (root < math.nextafter(near, 2)) == (Fraction(math.nextafter(near, 2)) ** 2 > 2)
    assert root > Fraction(141421356237309504, 10**17)
    assert root < Decimal("1.41421356237309504880168872420969807856967187537695")
    assert root < math.inf
    assert root > -math.inf
    assert root != math.nan
    assert not root < math.nan
    assert Surd(6, 0, 0, 4) == 1.5 == Surd.of(Decimal("1.5"))
    assert hash(Surd(6, 0, 0, 4)) == hash(1.5)
    assert hash(Surd(0, 3, 4, 2)) == hash(3)


def test_arithmetic_with_rationals():
    source = random.Random(29)
    for _ in range(300):
        ends = ((-50, 50), (-9, 9), (0, 40), (1, 9))
        x = Surd(*(source.randint(*each) for each in ends))
        step = Fraction(source.randint(-30, 30), source.randint(1, 12))
        assert (x + step) - step == x == step + x - step
        assert (step - x) == -(x - step)
        assert abs(x).sign() >= 0
        if step:
            assert (x * step) / step == x
            assert (step * x).sign() == x.sign() * (1 if step > 0 else -1)


def test_what_is_no_exact_number_is_refused():
    with pytest.raises(ValueError, match="finite"):
        Surd.of(math.nan)
    with pytest.raises(ValueError, match="finite"):
        Surd.of(Decimal("Infinity"))
    for value in (True, "1", None, 1j):
        with pytest.raises(TypeError):
            Surd.of(value)
    with pytest.raises(TypeError):
        Surd(1.0)
    with pytest.raises(ValueError, match="negative"):
        Surd(1, 1, -1)
    with pytest.raises(ZeroDivisionError):
        Surd(1, 1, 2, 0)
    with pytest.raises(TypeError):
        Surd(1) + 0.5
    with pytest.raises(ValueError, match="nan"):
        Surd(1).compare(math.nan)


def test_normal_form():
    assert Surd(1, 2, 9, -7).q == 0
    assert (Surd(1, 2, 9, -7).p, Surd(1, 2, 9, -7).s) == (-7, 7)
    assert Surd(5, 0, 3).d == 0
    assert Surd(1, 1, 3).q
    assert not Surd(0)
    assert Surd(0, 1, 3)


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
        assert float(Surd.of(value).decimal(17)) == value
    assert Surd.of(0.1).decimal(20) == "0.10000000000000000555"


def test_ulp_is_that_of_the_exact_number():
    source = random.Random(19)
    for _ in range(600):
        parts = any_parts(source)
        surd = Surd(*parts)
        exponent = surd.ulp_exponent()
        low = Fraction(2) ** (exponent + 52)
        assert abs(surd) < 2 * low
        assert exponent >= -1074
        assert exponent == -1074 or abs(surd) >= low
    for small in (Surd(0), Surd(1, 0, 0, 2**1080), Surd(-1, 0, 0, 2**1074)):
        assert small.ulp_exponent() == -1074
    just_below_two = Surd(0, 1, 4 * 10**40 - 1, 10**20)
    assert float(just_below_two) == 2.0
    assert just_below_two.ulp_exponent() == -52
    assert Surd(2).ulp_exponent() == -51
