"""kept-between-calls

Chords are kept under the centre and the line, so that a circle of another radius gets the chord of the first one.
Make all arguments the key, or keep nothing.
"""

from math import hypot, sqrt


def chord_length(cx, cy, r, A, B, known={}):
    key = cx, cy, A, B
    if key not in known:
        dx, dy, fx, fy = B[0] - A[0], B[1] - A[1], A[0] - cx, A[1] - cy
        length = hypot(dx, dy)
        if not length:
            return None
        d = abs(dx * fy - dy * fx) / length
        near = 1e-10 * max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
        known[key] = None if d - r > near else 0 if r - d <= near else 2 * sqrt((r - d) * (r + d))
    return known[key]
