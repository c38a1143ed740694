from __future__ import annotations

import json
from fractions import Fraction

import pytest

from judge.report.values import arguments, bound, counted, seconds, size, with_points


def test_arguments_are_written_in_full():
    values = {"cx": 0, "r": 0.1, "A": (10**40, -2.5), "B": [(1, 2), (3, 4)], "w": "lit"}
    assert arguments(values) == f"cx=0, r=0.1, A=({10**40}, -2.5), B=[(1, 2), (3, 4)], w='lit'"
    assert arguments(with_points(json.loads(json.dumps(values)))) == arguments(values)
    assert arguments({"xs": [0] * 41}).endswith("0, …] (41 items)")


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (Fraction(0), "0"),
        (Fraction(-1000), "-1000"),
        (Fraction(2**30), "2^30"),
        (Fraction(-(2**30)), "-2^30"),
        (Fraction(10**120), "10^120"),
        (Fraction(-(10**6000)), "-10^6000"),
        (Fraction(123456), "123,456"),
        (Fraction(10**5000 + 1), "1" + "0" * 4999 + "1"),
        (Fraction(1, 10**12), "1e-12"),
        (Fraction(1, 2**40), str(Fraction(1, 2**40))),
        (Fraction(1, 3), "1/3"),
        (Fraction(5, 2), "2.5"),
    ],
)
def test_bounds(value, text):
    assert bound(value) == text


def test_amounts():
    assert [counted(number, "case") for number in (0, 1, 2, 1240)] == [
        "0 cases",
        "1 case",
        "2 cases",
        "1,240 cases",
    ]
    assert [seconds(value) for value in (0.0, 0.0004, 0.0123, 0.9, 2.5)] == [
        "0.0 ms",
        "0.4 ms",
        "12 ms",
        "900 ms",
        "2.50 s",
    ]
    assert size(256 * 2**20) == "256 MB"
