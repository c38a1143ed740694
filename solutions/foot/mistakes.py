"""How the foot of the perpendicular goes wrong."""

from math import hypot


def projection(A, B, C):
    "right"
    # + from-B: A, B = B, A
    # + from-B: A, B = (B, A) if A[0] == B[0] and A[1] > B[1] else (A, B)
    # : A line that goes straight down is reversed, and t then counts from B. Leave A and B as they are given.
    dx, dy = B[0] - A[0], B[1] - A[1]
    # ? point-for-direction: dx, dy = B
    fx, fy = C[0] - A[0], C[1] - A[1]
    # ? forgotten-centre: fx, fy = C
    # : A is not subtracted from C: what is projected is the way from the origin. Take C − A.
    # ? forgotten-centre: fx, fy = -A[0], -A[1]
    # ? c-to-a: fx, fy = A[0] - C[0], A[1] - C[1]
    square = dx * dx + dy * dy
    if square == 0:
        return None
        # ? no-degenerate: return 0, A
        # @ If A and B are equal
        # ? no-degenerate: return None, A
        # : A = B is answered with None for t and with the point itself for F. There is no line then: the
        # : whole answer is None.
    # + absolute-epsilon: if square < {1e-15..1e-9/6}: return None
    # : A and B are taken for one point where the square of their distance is below a fixed number. Only A =
    # : B is no line: compare with ==.
    # + loose-epsilon: if hypot(dx, dy) <= {1e-8..1e-6/2} * max(abs(fx), abs(fy)): return None
    t = (fx * dx + fy * dy) / square
    # ? not-divided: t = fx * dx + fy * dy
    # ? not-divided: t = (fx * dx + fy * dy) / hypot(fx, fy) if fx or fy else 0.0
    # : f·D is divided by the length of C − A, not of B − A. Divide it by D·D.
    # ? divided-once: t = (fx * dx + fy * dy) / hypot(dx, dy)
    # ? swapped-coordinates: t = (fx * dy - fy * dx) / square
    # : The cross product is taken: it says how far from the line C is. The dot product is fx·dx + fy·dy.
    # ? global-frame: t = (C[0] * dx + C[1] * dy - (A[0] * dx + A[1] * dy)) / square
    # ? floor-division: t = (fx * dx + fy * dy) // square
    # + clamped: t = min(1, max(0, t))
    # @ goes on for ever
    # + clamped: if not 0 <= t <= 1: return None
    # : A foot that is not between A and B is answered with None. The line has no ends.
    x, y = A[0] + t * dx, A[1] + t * dy
    # ? from-origin: x, y = t * dx, t * dy
    # ? mirror-image: x, y = 2 * (A[0] + t * dx) - C[0], 2 * (A[1] + t * dy) - C[1]
    # + t-from-foot: t = (x - A[0]) / dx if abs(dx) >= abs(dy) else (y - A[1]) / dy
    # + t-in-length: t = t * hypot(dx, dy)
    # @ t is 0 at A and 1 at B
    return t, (x, y)
    # ? point-only: return x, y
    # @ Return `(t, (x, y))`
    # ? point-only: return t, x, y
    # : The three numbers are not put together as t and a point. The answer is (t, (x, y)).
    # ? swapped-coordinates: return t, (y, x)
    # : The foot comes as (y, x). Return (x, y).


def slope(A, B, C):
    "slope-intercept"
    if A == B:
        return None
    m = (B[1] - A[1]) / (B[0] - A[0])
    # = m = (B[1] - A[1]) / (B[0] - A[0]) if B[0] != A[0] else 0.0
    # = m = (B[1] - A[1]) / ((B[0] - A[0]) or 1e-9)
    # = m = (B[1] - A[1]) / ((B[0] - A[0]) or 1e-12)
    # + slope-intercept: if A[0] == B[0]: return None
    # : An upright line, which has no slope, is answered with None. Work with B − A and the dot product.
    n = A[1] - m * A[0]
    x = (C[0] + m * (C[1] - n)) / (1 + m * m)
    y = m * x + n
    t = (x - A[0]) / (B[0] - A[0] or 1e-12)
    return t, (x, y)
