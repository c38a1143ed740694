"""The distance of two points, exact: the root of an integer."""

from judge.exact import Surd
from judge.problem.declare import Real, group


def solve(P, Q):
    square = (Q[0] - P[0]) ** 2 + (Q[1] - P[1]) ** 2
    return Real(Surd(0, 1, square), 1)  # Surd(p, q, d, s) is the number (p + q·√d)/s


def points(reach):
    """Two points with coordinates up to `reach`."""

    def case(draw):
        x, y, u, v = (draw.integer(-reach, reach) for _ in range(4))
        return (x, y), (u, v)

    return case


INTERVIEW = [  # what a textbook asks
    group("small", "Small coordinates of either sign.", points(9)),
]
PRODUCTION = [  # what comes up in use
    group("large", "Coordinates up to 2**30.", points(2**30)),
]
