"""fractions

A float is a fraction, and so is everything here: t = f·D / D·D, and F = A + t·D. Only the answer is rounded.
"""

from fractions import Fraction


def foot(A, B, C):
    ax, ay, bx, by, cx, cy = map(Fraction, (*A, *B, *C))
    dx, dy = bx - ax, by - ay
    square = dx * dx + dy * dy
    if square == 0:
        return None
    t = ((cx - ax) * dx + (cy - ay) * dy) / square
    return float(t), (float(ax + t * dx), float(ay + t * dy))
