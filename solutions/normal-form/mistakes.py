"""How the normal form of a line goes wrong."""

from math import hypot


def turned(A, B):
    "right"
    # + right-side: A, B = B, A
    # @ positive on its left
    # : The normal points to the left of the way from B to A, which is the right of the way from A to B.
    dx, dy = B[0] - A[0], B[1] - A[1]
    # ? point-for-direction: dx, dy = B
    # @ goes on for ever
    length = hypot(dx, dy)
    # ? not-normalised: length = dx * dx + dy * dy
    # @ a² + b² = 1
    # : The normal is divided by |D|², not by |D|. Divide by the root.
    # ? not-normalised: length = abs(dx) + abs(dy)
    # : The normal is divided by |dx| + |dy|, which is not its length. Divide by the root of dx² + dy².
    if length == 0:
        return None
        # ? no-degenerate: return 0, 0, 0
        # @ If A and B are equal
        # ? no-degenerate: return 0.0, 1.0, -A[1]
        # : A = B is answered with the level line through that point. There is no line then: the contract
        # : asks for None.
    # + absolute-epsilon: if length < 1e-8: return None
    # + loose-epsilon: if length <= 1e-8 * max(abs(A[0]), abs(A[1])): return None
    a, b = -dy / length, dx / length
    # ? swapped-coordinates: a, b = dx / length, -dy / length
    # : The direction itself is taken for the normal. The normal is perpendicular to it: (−dy, dx) by the length.
    # ? swapped-coordinates: a, b = dy / length, dx / length
    # : (dy, dx) is taken for the perpendicular: a sign is missing. It is (−dy, dx).
    # + positive-a: if a < 0: a, b = -a, -b
    # + positive-a: if b < 0: a, b = -a, -b
    # : The sign is chosen so that b is not negative, as if the left were always above. It follows from A→B.
    c = -(a * A[0] + b * A[1])
    # = c = -(a * B[0] + b * B[1])
    # ? c-sign: c = a * A[0] + b * A[1]
    # ? c-from-B-swapped: c = -(a * A[0] + b * B[1])
    # ? c-from-B-swapped: c = -(a * A[1] + b * A[0])
    # : a is multiplied by a y, and b by an x. It is a·x + b·y.
    # ? abs-distance: c = abs(a * A[0] + b * A[1])
    # ? abs-distance: c = -abs(a * A[0] + b * A[1])
    # : c is the distance of the origin made negative. Its sign is that of the side on which the origin is.
    # ? global-frame: c = (A[0] * B[1] - B[0] * A[1]) / length
    # ? c-not-divided: c = dy * A[0] - dx * A[1]
    return a, b, c
    # ? swapped-coordinates: return dx / length, dy / length, c
    # : The direction itself is taken for the normal. The normal is perpendicular to it: (−dy, dx) by the length.
    # ? not-normalised: return -dy, dx, dy * A[0] - dx * A[1]
    # : The normal is not divided by its length, the root of dx² + dy².
    # ? nested-answer: return (a, b), c


def slope(A, B):
    "slope-intercept"
    if A == B:
        return None
    # + slope-intercept: if A[0] == B[0]: return None
    # : An upright line, which has no slope, is answered with None. Work with B − A.
    m = (B[1] - A[1]) / (B[0] - A[0])
    # = m = (B[1] - A[1]) / ((B[0] - A[0]) or 1e-9)
    # = m = (B[1] - A[1]) / ((B[0] - A[0]) or 1e-12)
    s = hypot(m, 1)
    if B[0] < A[0]:
        s = -s
    # = pass
    return -m / s, 1 / s, -(A[1] - m * A[0]) / s
