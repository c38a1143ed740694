"""The real roots of a·t² + 2·b·t + c = 0 for the numbers as they are, to the last digits."""

from __future__ import annotations

from fractions import Fraction

from judge.exact import Surd
from judge.exact.dyadic import integers
from judge.topics.quadratics.recipes import BUILDERS as RECIPES
from judge.values import Real

BUILDERS = dict(RECIPES)
LEAST, MOST = Fraction(1, 10**300), 10**300  # of a root that is not 0


def solve(a, b, c):
    """(−b ± √Δ)/a for Δ = b² − a·c, ascending; −c/2b for a = 0. A root is one that doubles hold."""
    (m, n, k), _ = integers(a, b, c)
    if any(int(float(x)) != x for x in (a, b, c) if type(x) is int):
        return None, "no double holds one of the numbers"
    if m < 0:
        m, n, k = -m, -n, -k
    delta = n * n - m * k
    if m == 0:
        roots = [Surd(-k, 0, 0, 2 * n)] if n else []
    elif delta > 0:
        roots = [Surd(-n, -1, delta, m), Surd(-n, 1, delta, m)]
    else:
        roots = [] if delta else [Surd(-n, 0, 0, m)]
    broken = any(x.sign() and not LEAST <= abs(x) <= MOST for x in roots)
    answer = None if m == n == k == 0 else [Real(x) for x in roots]
    return answer, "a root is beyond the doubles" if broken else None
