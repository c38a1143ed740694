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
from judge.exact import Surd, rounding
from judge.geometry import Line
from judge.values import Accepted, Real, Rejection, Tolerance, parse
from judge.values.interval import exact_ends, measure, widths

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
    outcome = REAL.check(raw, REAL.target(answer, tolerance), ask(answer, tolerance))
    return isinstance(outcome, Accepted)


def accepts_text(answer, tolerance, line) -> bool:
    outcome = REAL.check_line(line, REAL.target(answer, tolerance), ask(answer, tolerance))
    return isinstance(outcome, Accepted)


def fraction_json(value: Fraction):
    return {"fraction": [f"{value.numerator:x}", f"{value.denominator:x}"]}


def half_width(x: Fraction, tolerance: Tolerance, unit: Fraction) -> Fraction:
    """The tolerance's definition, in Fractions, for a rational x."""
    slack = tolerance.ulps * Surd.of(x).ulp()
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
        assert exact_ends(answer.x, tolerance, answer.unit) == (x - width, x + width)
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
            for side, end in zip((-1, 1), exact_ends(x, tolerance, unit), strict=True):
                near = Fraction(end.decimal(60))
                step = abs(near) * TINY
                assert accepts(answer, tolerance, fraction_json(near - side * step))
                assert not accepts(answer, tolerance, fraction_json(near + side * step))
                distance = abs((flint.arb(x.p) + x.q * flint.arb(x.d).sqrt()) / x.s - flint_of(near))
                widest = flint_of(Fraction(x.ulp())) * flint_of(tolerance.ulps) + max_of(
                    flint_of(tolerance.extent * Fraction(unit.p, unit.s)),
                    flint_of(tolerance.relative) * abs((flint.arb(x.p) + x.q * flint.arb(x.d).sqrt()) / x.s),
                )
                assert abs(distance - widest) < flint_of(step)


def flint_of(value: Fraction) -> flint.arb:
    return flint.arb(flint.fmpq(value.numerator, value.denominator))


def max_of(one: flint.arb, two: flint.arb) -> flint.arb:
    return one if one > two else two


def assert_measured(x, tolerance, unit, *roots):
    """The ends of the doubles that are accepted are the exact ones, rounded inward."""
    low, high = exact_ends(x, tolerance, unit)
    found = measure(x, tolerance, unit, *roots)
    assert (found.lo, found.hi) == (low.round_up(), high.round_down())
    assert found.nearest == float(x)
    return found


def test_intervals_of_doubles_are_the_exact_ones_rounded_inward():
    cases = [(Surd.of(x), Surd.of(unit)) for x, unit, _ in rational_cases(150)]
    cases += list(irrational_cases(100))
    cases += [(x / 10**18, unit / 10**9) for x, unit in irrational_cases(50)]
    for x, unit in cases:
        for tolerance in ALL:
            found = assert_measured(x, tolerance, unit)
            wanted = (x - Fraction(found.nearest)) / x.ulp()
            assert abs(wanted - Fraction(found.residual)) < Fraction(1, 10**9)
            assert Fraction(found.ulp) == x.ulp()
            again = measure(x, tolerance, unit)
            assert (again.lo, again.hi) == (found.lo, found.hi)


BOTTOMS = st.one_of(
    st.integers(1, 1000), st.integers(0, 80).map(lambda bits: 1 << bits), st.integers(1, 1 << 200)
)


def assert_rational_measured(x, tolerance, unit):
    found = assert_measured(x, tolerance, unit)
    away = (Fraction(x.p, x.s) - Fraction(found.nearest)) / x.ulp()
    assert (found.residual, found.ulp) == (float(away), float(x.ulp()))
    assert math.inf not in map(abs, found)


@given(st.integers(-(1 << 300), 1 << 300), BOTTOMS, BOTTOMS, BOTTOMS, st.sampled_from(ALL))
@settings(max_examples=150, deadline=None)
def test_every_rational(p, s, top, bottom, tolerance):
    assert_rational_measured(Surd(p, 0, 0, s), tolerance, Surd(top, 0, 0, bottom))


@pytest.mark.parametrize("exponent", [-1100, -1074, -1022, -905, -60, 0, 60, 905, 1020])
def test_beside_a_power_of_two_and_where_doubles_begin_and_end(exponent):
    # Just below a power of two the nearest double may be that power, which has the larger ulp.
    for hair in (-1, 0, 1):
        for tolerance in ALL:
            x = Surd.of(Fraction(2) ** exponent * (1 + Fraction(hair, 10**40)))
            assert_rational_measured(x, tolerance, Surd.of(1))


def test_doubles_next_to_the_ends():
    for x, unit in irrational_cases(100):
        for tolerance in (POINTS, RELATIVE, SIXTEEN):
            answer = Real(x, unit)
            lo, hi = measure(x, tolerance, unit)[:2]
            low, high = exact_ends(x, tolerance, unit)
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
    target = points.target(answer, tolerance)
    width = Fraction(11, 2**20)
    assert answer[0][0].unit == 11

    def outcome(y):
        return points.check([[6, y], [9, 16]], target, ask(answer, tolerance))

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
    target = REAL.target(answer, exactly)
    assert target[0] > target[1]  # no double is accepted
    within_one = Tolerance(extent=Fraction(1))
    assert accepts(answer, within_one, x + 1)
    assert not accepts(answer, within_one, x + 2)
    assert accepts(answer, within_one, 2.0**60)


def test_zero_takes_the_zero_tolerance_times_an_irrational_unit():
    unit = Surd(0, 1, 2)
    tolerance = Tolerance(relative=Fraction(1, 2), zero=Fraction(1, 4))
    answer = Real(Surd(0), unit)
    assert exact_ends(answer.x, tolerance, unit) == (-unit / 4, unit / 4)
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
        REAL.target(Real(Surd(0, 1, 3), Surd(0, 1, 2)), POINTS)
    with pytest.raises(ProblemError, match="extent"):
        exact_ends(Surd(2), POINTS, Surd(0, 1, 2))


def test_a_relative_tolerance_of_one_reaches_zero_exactly():
    tolerance = Tolerance(relative=Fraction(1))
    answer = Real(Surd(0, 1, 2), Surd(1))
    assert accepts(answer, tolerance, 0)
    assert not accepts(answer, tolerance, -5e-324)
    assert not accepts(answer, tolerance, fraction_json(-Fraction(1, 10**400)))


@pytest.mark.parametrize("bits", [54, 55, 56, 58, 62])
def test_enclosures_too_coarse_to_decide_are_noticed(bits):
    """With hardly more bits than a double has, most enclosures straddle something; no result may differ."""
    source = random.Random(53)
    wide = [  # an enclosure of many units, since q is large beside s
        (
            Surd(source.randint(-(10**6), 10**6), sign * source.randint(2, 10**6), source.randint(2, 99), 3),
            Surd(7),
        )
        for sign in (-1, 1)
        for _ in range(150)
    ]
    for x, unit in [*irrational_cases(150), *wide]:
        # Roots of such a precision that |x| itself is an integer of `bits` bits.
        k = bits - math.frexp(float(x))[1]
        if not x.q or k < 0:
            continue
        root = math.isqrt(x.d << 2 * k)
        for tolerance in (*ALL, Tolerance(relative=Fraction(1, 3), ulps=Fraction(1, 3))):
            assert_measured(x, tolerance, unit, lambda d, _, k=k, root=root: (k, root))


def test_fixed_point_enclosures_hold_what_they_enclose():
    source = random.Random(59)
    for _ in range(1000):
        d = source.randint(2, 10**6)
        q, s, k = (
            source.choice((-1, 1)) * source.randint(1, 10**4),
            source.randint(1, 50),
            source.randint(0, 30),
        )
        x = Surd(source.randint(-(10**6), 10**6), q, d, s)
        low, high = rounding.enclose(x.p, x.q, x.s, k, math.isqrt(d << 2 * k))
        assert low <= x * 2**k <= high
        near, width = source.randint(1 << 53, 1 << 60), source.randint(0, 9)
        exponent = near.bit_length() - 53
        tolerance = Tolerance(*(Fraction(source.randint(0, 9), source.randint(1, 9)) for _ in range(4)))
        unit = Fraction(source.randint(0, 99), source.randint(1, 99))
        inner, outer = widths(tolerance, Surd.of(unit), near, near + width, exponent, k)
        for size in (near, near + width):
            reach = max(tolerance.extent * unit * 2**k, tolerance.relative * size)
            assert inner <= reach + tolerance.ulps * 2**exponent <= outer


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
    target = REAL.target(answer, RELATIVE)
    assert all(map(math.isfinite, target))
    assert target[4] == math.ulp(1e308)
    assert target[0] > target[1]
    assert accepts(answer, RELATIVE, {"int": f"{10**400:x}"})
    assert accepts_text(answer, RELATIVE, "1" + "0" * 400)
    assert accepts_text(answer, RELATIVE, "1e400")
    assert not accepts_text(answer, RELATIVE, "1.1e400")
    assert not accepts(answer, RELATIVE, 1.7e308)


@pytest.mark.parametrize("x", [Surd(7, 0, 0, 3), Surd(1, 1, 2, 3), Surd(-1, -1, 2, 3)])
def test_ends_beyond_the_largest_double_are_the_largest_double(x):
    largest = Surd.of(sys.float_info.max)
    found = measure(x, Tolerance(extent=Fraction(3)), largest)
    assert (found.lo, found.hi) == (-sys.float_info.max, sys.float_info.max)
    assert found.nearest == float(x)
