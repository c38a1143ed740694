"""How the foot of the perpendicular goes wrong."""

from math import hypot


def projection(A, B, C):
    "right"
    # + from-B: A, B = B, A
    # + from-B: A, B = min(A, B), max(A, B)
    # : A and B are put in order, so t counts from B where B comes first. Leave them as they are given.
    # + from-B: A, B = (B, A) if A[0] == B[0] and A[1] > B[1] else (A, B)
    # : A line that goes straight down is reversed, and t then counts from B. Leave A and B as they are given.
    dx, dy = B[0] - A[0], B[1] - A[1]
    # ? point-for-direction: dx, dy = B
    fx, fy = C[0] - A[0], C[1] - A[1]
    # ? forgotten-centre: fx, fy = C
    # : A is not subtracted from C: what is projected is the way from the origin. Take C − A.
    # ? forgotten-centre: fx, fy = -A[0], -A[1]
    # ? c-to-a: fx, fy = A[0] - C[0], A[1] - C[1]
    # ? from-B: fx, fy = C[0] - B[0], C[1] - B[1]
    # : The way from B to C is projected, and t counted from A. Project the way from A.
    square = dx * dx + dy * dy
    if square == 0:
        return None
        # ? no-degenerate: return 0, A
        # @ If A and B are equal
        # ? no-degenerate: return 0.0, (A[0], A[1])
        # ? no-degenerate: return None, A
        # : A == B is answered with None for t and with the point itself for F. There is no line then: the whole
        # : answer is None.
    # ? no-degenerate: pass
    # : The division by D·D comes without asking whether it is 0: for A == B the program ends there. Return
    # : None before anything else.
    # + absolute-epsilon: if square < {1e-24..1e-9/3}: return None
    # : A and B are taken for one point where the square of their distance is below a fixed number. Only A == B
    # : is no line: compare with ==.
    # + absolute-epsilon: if abs(dx) < {1e-12..1e-6/2} and abs(dy) < {1e-12..1e-6/2}: return None
    # + loose-epsilon: if hypot(dx, dy) <= {1e-10..1e-6/2} * max(abs(fx), abs(fy)): return None
    t = (fx * dx + fy * dy) / square
    # ? not-divided: t = fx * dx + fy * dy
    # ? not-divided: t = (fx * dx + fy * dy) / hypot(fx, fy) if fx or fy else 0.0
    # : f·D is divided by the length of C − A, not of B − A. Divide it by D·D.
    # ? divided-once: t = (fx * dx + fy * dy) / hypot(dx, dy)
    # ? swapped-coordinates: t = (fx * dy - fy * dx) / square
    # : The cross product is taken: it says how far from the line C is. The dot product is fx·dx + fy·dy.
    # ? swapped-coordinates: t = (fx * dy + fy * dx) / square
    # ? global-frame: t = (C[0] * dx + C[1] * dy - (A[0] * dx + A[1] * dy)) / square
    # ? floor-division: t = (fx * dx + fy * dy) // square
    # + clamped: t = min(1, max(0, t))
    # @ goes on for ever
    # + clamped: t = max(0, t)
    # : t is not let below 0, as on a ray. The line goes on before A.
    # + clamped: t = min(1, t)
    # : t is not let above 1. The line goes on beyond B.
    # + clamped: if not 0 <= t <= 1: return None
    # : A foot that is not between A and B is answered with None. The line has no ends.
    x, y = A[0] + t * dx, A[1] + t * dy
    # ? from-origin: x, y = t * dx, t * dy
    # ? from-B: x, y = B[0] + t * dx, B[1] + t * dy
    # : t counts from A, and the foot is drawn from B. It is A + t·D.
    # ? mirror-image: x, y = 2 * (A[0] + t * dx) - C[0], 2 * (A[1] + t * dy) - C[1]
    # + t-from-foot: t = (x - A[0]) / dx if abs(dx) >= abs(dy) else (y - A[1]) / dy
    # + t-from-foot: t = ((x - A[0]) * dx + (y - A[1]) * dy) / square
    # + t-in-length: t = t * hypot(dx, dy)
    # @ t is 0 at A and 1 at B
    # + t-in-length: t = abs(t) * hypot(dx, dy)
    # : t is given as a distance from A, without its direction. It counts in lengths of B − A, and is negative
    # : before A.
    return t, (x, y)
    # ? point-only: return x, y
    # @ Return `(t, (x, y))`
    # ? point-only: return (x, y), t
    # : The point comes first, and then t. The answer is (t, (x, y)).
    # ? point-only: return t, x, y
    # : The three numbers are not put together as t and a point. The answer is (t, (x, y)).
    # ? point-only: return t
    # : Only t is returned. The answer is (t, (x, y)).
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
