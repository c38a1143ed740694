"""How the side of a line goes wrong: right ways to it, and mistakes beside the lines that they spoil."""

from math import atan2, hypot, sin


def wrap(x):
    return (x + (1 << 31)) % (1 << 32) - (1 << 31)


def sign(x):
    return (x > 0) - (x < 0)


def product(A, B, P):
    "right"
    dx, dy = B[0] - A[0], B[1] - A[1]
    # ? forgotten-start@all: dx, dy = B
    # ? sum-for-difference: dx, dy = B[0] + A[0], B[1] + A[1]
    # ? swapped-coordinates: dx, dy = B[1] - A[1], B[0] - A[0]
    # : The way from A to B has x and y exchanged. dx is the difference of the x.
    fx, fy = P[0] - A[0], P[1] - A[1]
    # = fx, fy = P[0] - B[0], P[1] - B[1]
    # ? forgotten-start@all: fx, fy = P
    # : Neither B nor P is seen from A: the line is taken to begin at (0, 0). Subtract A from both.
    # ? sides-exchanged: fx, fy = A[0] - P[0], A[1] - P[1]
    # @ y grows upwards
    # : For example, the cross product is taken from P to A. Take P - A.
    # ? sum-for-difference: fx, fy = P[0] + A[0], P[1] + A[1]
    # ? forgotten-start: fx, fy = P[0] - A[0], P[1]
    # : A is subtracted from P in x only. Subtract it in y as well.
    # + segment-for-line: if not min(A[0], B[0]) <= P[0] <= max(A[0], B[0]): return 0
    # @ goes on for ever
    # : Points whose x is not between those of A and B get 0. The line goes on for ever, and so do its sides.
    # + above-for-left: return sign(fy)
    # : Only the height above A is looked at, as if the line were level. Take the cross product.
    # + above-for-left: return sign(-fx)
    # : Only x is looked at, as if the line were upright. Take the cross product.
    cross = dx * fy - dy * fx
    # = cross = (B[0] - P[0]) * (A[1] - P[1]) * -1 + (B[1] - P[1]) * (A[0] - P[0])
    # ? dot-for-cross: cross = dx * fx + dy * fy
    # ? dot-for-cross: cross = dx * fx - dy * fy
    # : x is multiplied with x and y with y. In the cross product each x meets a y.
    # ? swapped-coordinates: cross = dx * fy + dy * fx
    # : The two products are added. The cross product is their difference.
    # ? float-arithmetic: cross = float(dx) * fy - float(dy) * fx
    # ? float-arithmetic: cross = sin(atan2(fy, fx) - atan2(dy, dx)) if fx or fy else 0
    # : The angles of the two ways are compared. An angle is rounded, and small differences are lost. Take the cross
    # : product, in whole numbers.
    # ? angles-compared: cross = atan2(fy, fx) - atan2(dy, dx)
    # ? overflow-32: cross = wrap(dx * fy - dy * fx)
    # @ of whole numbers
    # ? nearly-on-is-on: cross = cross if (cross := dx * fy - dy * fx) ** 2 > 1 else 0
    # ? nearly-on-is-on: cross = (lambda k: 0 if abs(k) <= 1e-6 * hypot(dx, dy) * hypot(fx, fy) else k)(dx * fy - dy * fx)
    # : A point that is off by a small part of the figure's own size counts as on the line. In whole numbers 0 is
    # : exact: compare with 0.
    if cross > 0:
        return 1
        # ? number-for-sign@sign: return cross
        # ? boolean-answer@sign: return True
    if cross < 0:
        return -1
        # ? number-for-sign@sign: return cross
        # ? boolean-answer@sign: return False
        # ? edge-missed: return 0
        # @ if it is on the line
        # : What is on the right is answered with 0. It is -1; only a point on the line is 0.
        # ? boolean-answer: return False
        # : False is returned for the right. The answer is a number: -1.
    return 0
    # ? edge-missed: return None
    # : A point on the line gets None. It is a place like the others: return 0.
    # ? boolean-answer@sign: return False


def height(A, B, P):
    "above-for-left"
    if A[0] == B[0]:
        return sign(A[0] - P[0]) * sign(B[1] - A[1])
        # = return sign(P[0] - A[0])
        # = return sign(A[0] - P[0])
        # = return 0
    m = (B[1] - A[1]) / (B[0] - A[0])
    return sign(P[1] - (m * (P[0] - A[0]) + A[1]))
    # = return sign(P[1] - (m * P[0] + A[1] - m * A[0]))


def slope(A, B, P):
    "slope-intercept"
    m = (B[1] - A[1]) / (B[0] - A[0])
    n = A[1] - m * A[0]
    # = n = B[1] - m * B[0]
    return sign(P[1] - (m * P[0] + n))
    # = return sign(P[1] - (m * P[0] + n)) * sign(B[0] - A[0])
    # = return sign(P[1] - A[1] - m * (P[0] - A[0])) * sign(B[0] - A[0])


def steep(A, B, P):
    "slope-intercept\n\nThe slope of an upright line is set to 0 or to 1,000,000. It has none: take the cross product."
    m = (B[1] - A[1]) / (B[0] - A[0]) if A[0] != B[0] else 0
    # = m = (B[1] - A[1]) / (B[0] - A[0]) if A[0] != B[0] else 10**6
    return sign(P[1] - A[1] - m * (P[0] - A[0])) * sign(B[0] - A[0] or 1)
