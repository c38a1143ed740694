"""Acceptance decided exactly: on the boundary and 1e-20 (relative) to either side, in any form of answer."""

from __future__ import annotations

import math
import random
import sys
from fractions import Fraction

import flint
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from judge.errors import ProblemError
from judge.exact import Surd
from judge.geometry import Line
from judge.values import check
from judge.values.answers import Real, Tolerance, accepted_doubles, exact_ends
from judge.values.check import Accepted, Rejection
from judge.values.grammar import parse

POINTS = Tolerance(extent=Fraction(1, 10**9), ulps=Fraction(4))
RELATIVE = Tolerance(relative=Fraction(1, 10**9), zero=Fraction(1, 10**12))
SIXTEEN = Tolerance(ulps=Fraction(16))
MIXED = Tolerance(Fraction(1, 10**6), Fraction(1, 10**9), Fraction(1, 10**5), Fraction(3, 2))
ALL = (POINTS, RELATIVE, SIXTEEN, MIXED, Tolerance())
TINY = Fraction(1, 10**20)
REAL = parse("real")


def ask(answer, tolerance):
    return lambda: (answer, tolerance)


def accepts(answer, tolerance, raw) -> bool:
    outcome = check.check(REAL, raw, check.target(REAL, answer, tolerance), ask(answer, tolerance))
    return isinstance(outcome, Accepted)


def accepts_text(answer, tolerance, line) -> bool:
    outcome = check.check_line(REAL, line, check.target(REAL, answer, tolerance), ask(answer, tolerance))
    return isinstance(outcome, Accepted)


def fraction_json(value: Fraction):
    return {"fraction": [f"{value.numerator:x}", f"{value.denominator:x}"]}


def half_width(x: Fraction, tolerance: Tolerance, unit: Fraction) -> Fraction:
    """The tolerance's definition, in Fractions, for a rational x."""
    slack = tolerance.ulps * Fraction(2) ** Surd.of(x).ulp_exponent()
    if x == 0:
        return max(tolerance.extent, tolerance.zero) * unit + slack
    return max(tolerance.extent * unit, tolerance.relative * abs(x)) + slack


def rational_cases(count: int):
    source = random.Random(41)
    for _ in range(count):
        x = Fraction(source.randint(-(10**9), 10**9), source.choice((1, 3, 7, 1000, 2**40, 10**12 + 39)))
        if source.random() < 0.1:
            x = Fraction(0)
        yield x, Fraction(source.randint(1, 10**9), source.choice((1, 2**20, 9))), source.choice(ALL)


def test_fractions_on_the_boundary_of_a_rational_answer():
    for x, unit, tolerance in rational_cases(400):
        answer = Real(Surd.of(x), Surd.of(unit))
        width = half_width(x, tolerance, unit)
        assert exact_ends(answer, tolerance) == (x - width, x + width)
        for side in (-1, 1):
            edge = x + side * width
            step = abs(edge) * TINY or TINY
            assert accepts(answer, tolerance, fraction_json(edge))
            assert accepts(answer, tolerance, fraction_json(edge - side * step)) == (width > 0)
            assert not accepts(answer, tolerance, fraction_json(edge + side * step))


def test_decimal_text_on_the_boundary():
    source = random.Random(43)
    for _ in range(400):
        x = Fraction(source.randint(-(10**12), 10**12), 10**6)
        tolerance = Tolerance(relative=Fraction(1, 10 ** source.randint(3, 12)))
        answer = Real(Surd.of(x), Surd(1))
        for side in (-1, 1):
            edge = x * (1 + side * tolerance.relative)
            text = decimal_of(edge, 40)
            outward = 1 if edge > x else -1
            last = Fraction(outward, 10**40)
            assert Fraction(text) == edge
            assert accepts_text(answer, tolerance, text)
            assert accepts(answer, tolerance, {"decimal": text})
            assert accepts_text(answer, tolerance, decimal_of(edge - last, 40)) == (x != 0)
            assert not accepts_text(answer, tolerance, decimal_of(edge + last, 40))


def decimal_of(value: Fraction, places: int) -> str:
    scaled = value * 10**places
    assert scaled.denominator == 1
    digits = str(abs(scaled.numerator)).rjust(places + 1, "0")
    return ("-" if value < 0 else "") + digits[:-places] + "." + digits[-places:]


def irrational_cases(count: int):
    source = random.Random(47)
    made = 0
    while made < count:
        numbers = [source.randint(-(10**9), 10**9) for _ in range(7)]
        if source.random() < 0.3:
            numbers = [source.uniform(-1e9, 1e9) for _ in range(7)]
        line = Line.through(*numbers[:2], abs(numbers[2]), tuple(numbers[3:5]), tuple(numbers[5:]))
        if line.delta > 0:
            found = line.real_point(source.choice((-1, 1)))[source.randrange(2)]
            if isinstance(found.x, Surd) and found.x.q:
                made += 1
                yield found.x, Surd.of(found.unit)


def test_fractions_around_the_boundary_of_an_irrational_answer():
    """The ends are irrational: 1e-20 inside is accepted, 1e-20 outside is not; flint agrees."""
    flint.ctx.prec = 500
    for x, unit in irrational_cases(60):
        for tolerance in (POINTS, RELATIVE, SIXTEEN, MIXED):
            answer = Real(x, unit)
            for side, end in zip((-1, 1), exact_ends(Real(x, unit), tolerance), strict=True):
                near = Fraction(end.decimal(60))
                step = abs(near) * TINY
                assert accepts(answer, tolerance, fraction_json(near - side * step))
                assert not accepts(answer, tolerance, fraction_json(near + side * step))
                distance = abs((flint.arb(x.p) + x.q * flint.arb(x.d).sqrt()) / x.s - flint_of(near))
                widest = flint_of(Fraction(2) ** x.ulp_exponent()) * flint_of(tolerance.ulps) + max_of(
                    flint_of(tolerance.extent * Fraction(unit.p, unit.s)),
                    flint_of(tolerance.relative) * abs((flint.arb(x.p) + x.q * flint.arb(x.d).sqrt()) / x.s),
                )
                assert abs(distance - widest) < flint_of(step)


def flint_of(value: Fraction) -> flint.arb:
    return flint.arb(flint.fmpq(value.numerator, value.denominator))


def max_of(one: flint.arb, two: flint.arb) -> flint.arb:
    return one if one > two else two


def assert_measured(x, tolerance, unit):
    """The doubles that are accepted end where the exact ends are, rounded inward; all are finite."""
    low, high = exact_ends(Real(x, unit), tolerance)
    lo, hi, nearest = accepted_doubles(Real(x, unit), tolerance)
    assert (lo, hi) == (low.round_up(), high.round_down())
    assert nearest == float(x)
    assert all(map(math.isfinite, (lo, hi, nearest)))


def test_intervals_of_doubles_are_the_exact_ones_rounded_inward():
    cases = [(Surd.of(x), Surd.of(unit)) for x, unit, _ in rational_cases(150)]
    cases += list(irrational_cases(100))
    cases += [(x / 10**18, unit / 10**9) for x, unit in irrational_cases(50)]
    for x, unit in cases:
        for tolerance in ALL:
            assert_measured(x, tolerance, unit)


BOTTOMS = st.one_of(
    st.integers(1, 1000), st.integers(0, 80).map(lambda bits: 1 << bits), st.integers(1, 1 << 200)
)


@given(st.integers(-(1 << 300), 1 << 300), BOTTOMS, BOTTOMS, BOTTOMS, st.sampled_from(ALL))
@settings(max_examples=150, deadline=None)
def test_every_rational(p, s, top, bottom, tolerance):
    assert_measured(Surd(p, 0, 0, s), tolerance, Surd(top, 0, 0, bottom))


@pytest.mark.parametrize("exponent", [-1100, -1074, -1022, -905, -60, 0, 60, 905, 1020])
def test_beside_a_power_of_two_and_where_doubles_begin_and_end(exponent):
    # Just below a power of two the nearest double may be that power, which has the larger ulp.
    for hair in (-1, 0, 1):
        for tolerance in ALL:
            x = Surd.of(Fraction(2) ** exponent * (1 + Fraction(hair, 10**40)))
            assert_measured(x, tolerance, Surd.of(1))


def test_doubles_next_to_the_ends():
    for x, unit in irrational_cases(100):
        for tolerance in (POINTS, RELATIVE, SIXTEEN):
            answer = Real(x, unit)
            lo, hi, _ = accepted_doubles(answer, tolerance)
            low, high = exact_ends(Real(x, unit), tolerance)
            for inside in (lo, hi, float(x)):
                assert accepts(answer, tolerance, inside)
                # The text of a double is another number, a shorter one: it is judged as what it says.
                text = repr(inside)
                assert accepts_text(answer, tolerance, text) == (low <= Fraction(text) <= high)
            for outside in (math.nextafter(lo, -math.inf), math.nextafter(hi, math.inf)):
                assert not accepts(answer, tolerance, outside)
                assert not accepts(answer, tolerance, fraction_json(Fraction(outside)))


def test_a_pythagorean_boundary_is_accepted_in_every_form():
    """(6,7) and (9,16) on the circle about (6,12): rational points, exact boundaries."""
    points, answer = parse("points"), Line.through(6, 12, 5, (4, 1), (5, 4)).points()
    tolerance = Tolerance(extent=Fraction(1, 2**20))
    target = check.target(points, answer, tolerance)
    width = Fraction(11, 2**20)
    assert answer[0][0].unit == 11

    def outcome(y):
        return check.check(points, [[6, y], [9, 16]], target, ask(answer, tolerance))

    assert isinstance(outcome(float(7 + width)), Accepted)
    assert isinstance(outcome(fraction_json(7 - width)), Accepted)
    assert isinstance(outcome({"decimal": decimal_of(7 + width, 20)}), Accepted)
    assert isinstance(outcome(math.nextafter(float(7 + width), 8)), Rejection)
    assert isinstance(outcome(fraction_json(7 + width + TINY)), Rejection)
    assert isinstance(outcome({"decimal": decimal_of(7 + width + Fraction(1, 10**25), 30)}), Rejection)


def test_large_integers_on_the_boundary():
    """2**53 + 1 is no double: an int answer is not judged as one."""
    x = 2**60 + 1
    answer = Real(Surd(x), Surd(1))
    exactly = Tolerance()
    assert accepts(answer, exactly, x)
    assert not accepts(answer, exactly, x - 1)
    assert not accepts(answer, exactly, float(x))
    assert accepts_text(answer, exactly, str(x))
    assert not accepts_text(answer, exactly, str(x + 1))
    target = check.target(REAL, answer, exactly)
    assert target[0] > target[1]  # no double is accepted
    within_one = Tolerance(extent=Fraction(1))
    assert accepts(answer, within_one, x + 1)
    assert not accepts(answer, within_one, x + 2)
    assert accepts(answer, within_one, 2.0**60)


def test_zero_takes_the_zero_tolerance_times_an_irrational_unit():
    unit = Surd(0, 1, 2)
    tolerance = Tolerance(relative=Fraction(1, 2), zero=Fraction(1, 4))
    answer = Real(Surd(0), unit)
    assert exact_ends(answer, tolerance) == (-unit / 4, unit / 4)
    assert accepts(answer, tolerance, 0)
    assert accepts(answer, tolerance, -0.0)
    assert accepts(answer, tolerance, 0.3535533905932737)
    assert not accepts(answer, tolerance, 0.3535533905932738)
    assert accepts(answer, tolerance, fraction_json(Fraction((unit / 4).decimal(40)) - Fraction(1, 10**39)))
    assert not accepts(
        answer, tolerance, fraction_json(Fraction((unit / 4).decimal(40)) + Fraction(1, 10**39))
    )


def test_an_extent_tolerance_of_an_irrational_unit_is_refused():
    with pytest.raises(ProblemError, match="extent"):
        check.target(REAL, Real(Surd(0, 1, 3), Surd(0, 1, 2)), POINTS)
    with pytest.raises(ProblemError, match="extent"):
        exact_ends(Real(Surd(2), Surd(0, 1, 2)), POINTS)


def test_a_relative_tolerance_of_one_reaches_zero_exactly():
    tolerance = Tolerance(relative=Fraction(1))
    answer = Real(Surd(0, 1, 2), Surd(1))
    assert accepts(answer, tolerance, 0)
    assert not accepts(answer, tolerance, -5e-324)
    assert not accepts(answer, tolerance, fraction_json(-Fraction(1, 10**400)))


@pytest.mark.parametrize("scale", [-1060, -1030, -600, 600, 1000])
def test_extreme_magnitudes(scale):
    """Subnormal, tiny and huge answers: the rounded ends still say what the exact ones do."""
    factor = Fraction(2) ** scale
    for x, unit in irrational_cases(15):
        x, unit = x * factor / 10**9, unit * factor / 10**9
        for tolerance in ALL:
            assert_measured(x, tolerance, unit)


def test_answers_beyond_the_largest_double():
    x = Surd(10**400, 1, 2)
    answer = Real(x, Surd(1))
    target = check.target(REAL, answer, RELATIVE)
    assert all(map(math.isfinite, target))
    assert target[2] == sys.float_info.max
    assert target[0] > target[1]
    assert accepts(answer, RELATIVE, {"int": f"{10**400:x}"})
    assert accepts_text(answer, RELATIVE, "1" + "0" * 400)
    assert accepts_text(answer, RELATIVE, "1e400")
    assert not accepts_text(answer, RELATIVE, "1.1e400")
    assert not accepts(answer, RELATIVE, 1.7e308)


@pytest.mark.parametrize("x", [Surd(7, 0, 0, 3), Surd(1, 1, 2, 3), Surd(-1, -1, 2, 3)])
def test_ends_beyond_the_largest_double_are_the_largest_double(x):
    largest = Surd.of(sys.float_info.max)
    found = accepted_doubles(Real(x, largest), Tolerance(extent=Fraction(3)))
    assert found[:2] == (-sys.float_info.max, sys.float_info.max)
    assert found[2] == float(x)
