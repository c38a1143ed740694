"""The quick way of measuring a rational number gives what the general, exact way gives."""

from __future__ import annotations

from fractions import Fraction
from math import inf

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from judge.exact import Surd
from judge.problem import Tolerance
from judge.values.interval import exact_ends, measure

TOLERANCES = (
    Tolerance(extent=Fraction(1, 10**9), ulps=Fraction(4)),
    Tolerance(relative=Fraction(1, 10**9), zero=Fraction(1, 10**12)),
    Tolerance(ulps=Fraction(32)),
    Tolerance(Fraction(1, 10**6), Fraction(1, 10**9), Fraction(1, 10**5), Fraction(3, 2)),
    Tolerance(),
)
BOTTOMS = st.one_of(
    st.integers(1, 1000), st.integers(0, 80).map(lambda bits: 1 << bits), st.integers(1, 1 << 200)
)


def general(x, tolerance, unit):
    low, high = exact_ends(x, tolerance, unit)
    nearest = float(x)
    away = (Fraction(x.p, x.s) - Fraction(nearest)) / x.ulp()
    return low.round_up(), high.round_down(), nearest, float(away), float(x.ulp())


@given(st.integers(-(1 << 300), 1 << 300), BOTTOMS, BOTTOMS, BOTTOMS, st.sampled_from(TOLERANCES))
@settings(max_examples=400, deadline=None)
def test_every_rational(p, s, top, bottom, tolerance):
    x, unit = Surd(p, 0, 0, s), Surd(top, 0, 0, bottom)
    assert tuple(measure(x, tolerance, unit)) == general(x, tolerance, unit)


@pytest.mark.parametrize("tolerance", TOLERANCES)
@pytest.mark.parametrize("exponent", [-1100, -1074, -1022, -905, -60, 0, 60, 905, 1020])
@pytest.mark.parametrize("hair", [-1, 0, 1])
def test_beside_a_power_of_two_and_where_doubles_begin_and_end(tolerance, exponent, hair):
    # Just below a power of two the nearest double may be that power, which has the larger ulp.
    x = Surd.of(Fraction(2) ** exponent * (1 + Fraction(hair, 10**40)))
    measured = measure(x, tolerance, Surd.of(1))
    assert tuple(measured) == general(x, tolerance, Surd.of(1))
    assert inf not in map(abs, measured)
