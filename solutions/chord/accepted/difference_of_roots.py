"""difference of the roots

The quadratic in t has the roots (−b ± √Δ)/a: their difference is 2√Δ/a, in lengths of D, and 2√Δ/|D| as a
length. Δ = r²a − k² by Lagrange's identity; it is held against a threshold that is a fourth power of a length.
"""

from math import sqrt


def chord_length(cx, cy, r, A, B):
    fx, fy = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    a = dx * dx + dy * dy
    if not a:
        return None
    reach = [abs(x) for x in (r, fx, fy, B[0] - cx, B[1] - cy)]
    k = dx * fy - dy * fx
    length = sqrt(a)
    # (r|D| − |k|)(r|D| + |k|), against (1e-10·e·|D|)·(2r|D|)
    delta = (r * length - abs(k)) * (r * length + abs(k))
    width = 1e-10 * max(reach) * length
    if abs(r * length - abs(k)) <= width:
        return 0.0
    if delta < 0:
        return None
    t = sqrt(delta) / a
    return 2 * t * length
