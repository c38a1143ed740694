"""Exact numbers and line-circle geometry over integers. Knows nothing of judging."""

from judge.exact.bands import Bands
from judge.exact.circle_line import CircleLine
from judge.exact.dyadic import Rational, integers, ratio
from judge.exact.signs import exact_root, root_sign, sign, two_root_sign
from judge.exact.surd import Surd, decimal_text

__all__ = [
    "Bands",
    "CircleLine",
    "Rational",
    "Surd",
    "decimal_text",
    "exact_root",
    "integers",
    "ratio",
    "root_sign",
    "sign",
    "two_root_sign",
]
