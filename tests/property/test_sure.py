"""Sure's signs are exact, and a length that it takes for clear is clear: against decimals of 400 digits."""

from __future__ import annotations

from decimal import Context, Decimal, localcontext
from fractions import Fraction
from math import isqrt

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from judge.geometry import DecisionWords, Root, Sure
from judge.geometry.sure import CLEAR
from judge.problem.declare import InvalidCase, decisions

SIDES = "it is below 0", "it is 0", "it is above 0"
WORDS = DecisionWords("The length is almost 0", "It must be 0, or at least 1e-7·e.", SIDES)
TINY = Decimal(10) ** -250  # a number of these sizes that is nearer to 0 is 0

wholes = st.one_of(st.integers(-50, 50), st.integers(-(2**80), 2**80))
naturals = st.one_of(st.integers(0, 60), st.integers(0, 2**120))
sizes = st.one_of(st.integers(1, 100), st.integers(1, 2**100))
positives = st.one_of(st.integers(1, 60), st.integers(1, 2**120))


def root(number: int) -> Decimal:
    return Decimal(number).sqrt()


def check(decide, length: Decimal, size: int, *, zero: bool = True, share: int = CLEAR) -> None:
    """`decide()` gives the length's sign, and raises only where it is neither 0 nor at least size/share."""
    if abs(length) < TINY:
        length = Decimal(0)
    least = Decimal(size) / share
    try:
        found = decide()
    except InvalidCase:
        assert least - abs(length) > TINY
        assert length or not zero
    else:
        assert found == (length > 0) - (length < 0)
        assert abs(length) - least > -TINY or (length == 0 and zero)


@st.composite
def sums(draw):
    """p, q, d, u, v with p + q√d + u√v of any size, often nearly or exactly 0."""
    p, q, d, u, v = (draw(part) for part in (wholes, wholes, naturals, wholes, naturals))
    kind = draw(st.sampled_from(("any", "near", "square", "double")))
    if kind == "double":  # q√d against a multiple of itself
        k = draw(st.integers(1, 9))
        v, u = d * k * k, -q
        q *= k
        p = draw(st.sampled_from((0, p)))
    elif kind == "square":
        d = isqrt(d) ** 2
        u = draw(st.sampled_from((0, u)))
        p = -q * isqrt(d) if u == 0 else p
    elif kind == "near":
        first, second = isqrt(q * q * d), isqrt(u * u * v)
        p = -(first if q > 0 else -first) - (second if u > 0 else -second) + draw(st.integers(-3, 3))
    return p, q, d, u, v


@given(sums(), sizes, positives, st.booleans(), st.integers(-40, 40))
@settings(max_examples=400)
def test_a_sign_is_exact_and_a_length_clear(terms, size, per, beside, shift):
    p, q, d, u, v = terms
    with localcontext(Context(prec=400)):
        length = (p + q * root(d) + u * root(v)) / root(per)
        if beside and abs(length) > TINY:  # the size for which this length is about the threshold
            size = max(1, int(abs(length) * CLEAR * (1 + Decimal(shift) * Decimal(2) ** -45)))
        check(lambda: Sure(size).sign(p, q, d, u, v, per=per, what=WORDS), length, size)
        check(
            lambda: Sure(size).sign(p, q, d, u, v, per=per, share=10**6, zero=False, what=WORDS),
            length,
            size,
            zero=False,
            share=10**6,
        )


@given(sums(), sizes, positives, positives)
def test_per_may_be_a_fraction(terms, size, top, bottom):
    p, q, d, u, v = terms
    with localcontext(Context(prec=400)):
        length = (p + q * root(d) + u * root(v)) / (Decimal(top) / bottom).sqrt()
        check(lambda: Sure(size).sign(p, q, d, u, v, per=Fraction(top, bottom), what=WORDS), length, size)


@given(naturals, st.integers(-3, 3), positives, sizes, st.booleans(), st.booleans(), st.integers(-40, 40))
@settings(max_examples=400)
def test_a_distance_is_the_length_of_a_root_less_a_radius(radius, off, per, size, near, beside, shift):
    square = max(0, radius * radius * per + off) if near else abs(off) * radius + per // 2
    with localcontext(Context(prec=400)):
        length = (Decimal(square) / per).sqrt() - radius
        if beside and abs(length) > TINY:
            size = max(1, int(abs(length) * CLEAR * (1 + Decimal(shift) * Decimal(2) ** -45)))
        check(lambda: Sure(size).distance(square, radius, per, what=WORDS), length, size)
        check(
            lambda: Sure(size).distance(square, radius, per, what=WORDS, zero=False), length, size, zero=False
        )


@given(naturals, st.integers(0, 2**40), st.integers(2, 2**60), sizes, st.sampled_from((None, 0, 1, 10**9)))
@settings(max_examples=400)
def test_nested_roots_have_exact_signs_and_certified_sizes(whole, part, d, size, off):
    per = Root(isqrt(part * part * d) + 1, -part, d)  # above 0, and often nearly 0
    radius = whole % 1000
    square = Root(whole, part * (whole % 2), d)  # every other one without a root
    if off is not None:
        square = Root(per.p * radius * radius + off, per.q * radius * radius, d)
    with localcontext(Context(prec=400)):
        length = (_value(square) / _value(per)).sqrt() - radius
        check(lambda: Sure(size).nested(square, radius, per, what=WORDS), length, size)
        check(
            lambda: Sure(size).nested(square, radius, per, what=WORDS, zero=False), length, size, zero=False
        )


def _value(number: Root) -> Decimal:
    return number.p + number.q * root(number.d)


@given(st.integers(1, 2**70), st.sampled_from((-1, 1)), naturals, st.integers(1, 1000), st.integers(2, 99))
def test_a_length_of_exactly_the_threshold_is_clear(length, side, radius, k, d):
    """Each of these lengths is `length`, at most the radius if it is inside; below it is more than that."""
    e, r = length * CLEAR, radius + length
    times = k * k * d
    decide = {
        "sign": lambda sure: sure.sign(side * length, what=WORDS),
        "per": lambda sure: sure.sign(side * k * length, per=k * k, what=WORDS),
        "root": lambda sure: sure.sign(0, side * length, d, per=d, what=WORDS),
        "roots": lambda sure: sure.sign(
            0, side * length, d, side * length, times, per=d * (k + 1) ** 2, what=WORDS
        ),
        "mixed": lambda sure: sure.sign(side * length - k, k, d * d, k * (1 - d), 1, what=WORDS),
        "fraction": lambda sure: sure.sign(side * length, per=Fraction(k * k, d * d), what=WORDS),
        "distance": lambda sure: sure.distance((r + side * length) ** 2 * d, r, d, what=WORDS),
        "nested": lambda sure: sure.nested(
            Root((r + side * length) ** 2 * k, (r + side * length) ** 2, d), r, Root(k, 1, d), what=WORDS
        ),
    }
    for name, found in decide.items():
        size = e * d // k if name == "fraction" else e
        assert found(Sure(size)) == side, name
        with pytest.raises(InvalidCase):
            found(Sure(size + 1))


@given(naturals, sizes, st.integers(1, 10**6))
def test_least_is_exact(square, size, share):
    allowed = square * share**2 >= size**2
    for zero in (True, False):
        if allowed or (square == 0 and zero):
            Sure(size).least(square, share, "The radius", zero=zero)
        else:
            with pytest.raises(InvalidCase, match="The radius is"):
                Sure(size).least(square, share, "The radius", zero=zero)


def test_a_decision_is_recorded_with_its_part_of_the_size():
    sure = Sure(100)
    with decisions() as made:
        assert (sure.sign(25, what=WORDS), sure.sign(-1, 1, 1, what=WORDS)) == (1, 0)
        assert sure.distance(9, 28, 1, what=WORDS) == -1
    sure.sign(25, what=WORDS)
    assert [decision.gap for decision in made] == [0.25, 0, -0.25]
    assert {decision.what for decision in made} == {WORDS.name}


def test_the_sentence_names_the_decision_and_the_gap():
    with pytest.raises(InvalidCase) as caught:
        Sure(10**12).sign(19, what=WORDS)
    assert str(caught.value) == "The length is almost 0 (gap 1.9e-11·e). It must be 0, or at least 1e-7·e."
    with pytest.raises(InvalidCase, match=r"^The radius is 5e-5·e. It must be 0, or at least 1e-4·e.$"):
        Sure(100_000).least(25, 10_000, "The radius")
    with pytest.raises(InvalidCase, match=r"^r1 is 0·e. It must be at least 1e-3·e.$"):
        Sure(100).least(0, 1000, "r1", zero=False)
