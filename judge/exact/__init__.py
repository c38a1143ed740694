"""Exact numbers over integers. Knows nothing of judging."""

from judge.exact.dyadic import Rational, integers, ratio
from judge.exact.signs import exact_root, root_sign, sign, two_root_sign
from judge.exact.surd import Surd

__all__ = [
    "Rational",
    "Surd",
    "exact_root",
    "integers",
    "ratio",
    "root_sign",
    "sign",
    "two_root_sign",
]
