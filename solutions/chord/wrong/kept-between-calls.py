"""kept-between-calls

Answers are kept in a dict whose key is the line alone, so that another circle gets the chord of the first one. Make
all arguments the key, or keep nothing.
"""

from math import hypot, sqrt

chords = {}


def chord_length(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    if (A, B) in chords:
        return chords[A, B]
    fx, fy = A[0] - cx, A[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / hypot(dx, dy)
    chords[A, B] = None if d > r + near else 0 if d >= r - near else 2 * sqrt((r - d) * (r + d))
    return chords[A, B]
