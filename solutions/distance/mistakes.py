"""How the distance of a point from a line goes wrong."""

from math import hypot, sqrt


def product(A, B, P):
    "right"
    dx, dy = B[0] - A[0], B[1] - A[1]
    # ? point-for-direction: dx, dy = B
    # ? point-for-direction: dx, dy = B[0] - P[0], B[1] - P[1]
    # : The direction goes from P to B, and the distance is that of P from that line. The line goes through A
    # : and B: its direction is B − A.
    fx, fy = A[0] - P[0], A[1] - P[1]
    # = fx, fy = P[0] - A[0], P[1] - A[1]
    # = fx, fy = P[0] - B[0], P[1] - B[1]
    # = fx, fy = B[0] - P[0], B[1] - P[1]
    # ? forgotten-point: fx, fy = A
    # ? forgotten-point: fx, fy = P
    # : A is not subtracted from P: the distance is that of P from the line through the origin. Take P − A.
    length = hypot(dx, dy)
    # = length = sqrt(dx * dx + dy * dy)
    # ? manhattan: length = abs(dx) + abs(dy)
    # ? manhattan: length = max(abs(dx), abs(dy))
    # : The length of D is taken as the larger of |dx| and |dy|. It is the root of dx² + dy².
    if length == 0:
        return None
        # ? no-degenerate: return 0
        # @ If A and B are equal
        # ? no-degenerate: return -1
        # : A = B is answered with -1. The contract asks for None, and no number.
    # + absolute-epsilon: if length < 1e-8: return None
    # + loose-epsilon: if length <= {1e-8..1e-6/2} * max(abs(fx), abs(fy)): return None
    k = dx * fy - dy * fx
    # ? swapped-coordinates: k = dx * fx + dy * fy
    # : The dot product is taken instead of the cross product: it says how far along the line the foot is.
    # : The cross product is dx·fy − dy·fx.
    # ? swapped-coordinates: k = dx * fy + dy * fx
    # : A plus stands in the cross product. It is dx·fy − dy·fx.
    # ? global-frame: k = A[0] * (B[1] - P[1]) + B[0] * (P[1] - A[1]) + P[0] * (A[1] - B[1])
    # ? global-frame: k = A[0] * B[1] - B[0] * A[1] + B[0] * P[1] - P[0] * B[1] + P[0] * A[1] - A[0] * P[1]
    d = abs(k) / length
    # ? segment-distance: d = (lambda t: hypot(fx + t * dx, fy + t * dy))(min(1, max(0, -(fx * dx + fy * dy) / length**2)))
    # @ goes on for ever
    # ? not-divided: d = abs(k)
    # ? not-divided: d = abs(k) / 2
    # : The area of the triangle is returned. Its base is |D| and its height the distance: divide by the
    # : length, and the doubled area it must be.
    # ? divided-by-square: d = abs(k) / length**2
    # ? half-area: d = abs(k) / (2 * length)
    # ? signed-distance: d = k / length
    # @ never negative
    # ? signed-distance: d = -k / length
    # ? foot-cancels: d = (lambda t: hypot(fx + t * dx, fy + t * dy))(-(fx * dx + fy * dy) / (dx * dx + dy * dy))
    # ? foot-cancels: d = sqrt(max(0.0, fx * fx + fy * fy - (fx * dx + fy * dy) ** 2 / (dx * dx + dy * dy)))
    # : The distance comes from Pythagoras, as |f|² less the square of the way along the line: two numbers that
    # : are nearly equal where P is close to the line. The cross product gives it without a difference of squares.
    # ? divided-first: d = abs(dx / length * fy - dy / length * fx)
    # ? normal-form-global: d = abs(-dy / length * P[0] + dx / length * P[1] - (-dy / length * A[0] + dx / length * A[1]))
    # ? normal-form-global: d = abs(dy * P[0] - dx * P[1] + B[0] * A[1] - B[1] * A[0]) / length
    # ? area-by-heron: d = (lambda p, q: 2 * sqrt(max(0.0, (p + q + length) * (p + q - length) * (p - q + length) * (q + length - p) / 16)) / length)(hypot(fx, fy), hypot(fx + dx, fy + dy))
    # ? squared: d = k * k / length**2
    return d


def slope(A, B, P):
    "slope-intercept"
    if A == B:
        return None
    # + slope-intercept: if A[0] == B[0]: return None
    # : An upright line, which has no slope, is answered with None. Work with B − A and the cross product.
    m = (B[1] - A[1]) / (B[0] - A[0])
    # = m = (B[1] - A[1]) / (B[0] - A[0]) if B[0] != A[0] else 0.0
    # = m = (B[1] - A[1]) / ((B[0] - A[0]) or 1e-9)
    # = m = (B[1] - A[1]) / ((B[0] - A[0]) or 1e-12)
    n = A[1] - m * A[0]
    return abs(m * P[0] - P[1] + n) / sqrt(m * m + 1)
