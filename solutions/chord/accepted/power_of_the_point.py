"""power of the point A

The distances from A to both ends of the chord, along the line and with their signs, have the product |f|² − r²:
the power of A. One of them is taken by the sum that loses nothing, and the other is the power by it.
"""

from math import copysign, hypot, sqrt


def chord_length(cx, cy, r, A, B):
    if tuple(A) == tuple(B):
        return None
    ux, uy = B[0] - A[0], B[1] - A[1]
    length = hypot(ux, uy)
    ux, uy = ux / length, uy / length
    fx, fy = A[0] - cx, A[1] - cy
    away = abs(ux * fy - uy * fx)
    slack = 1e-10 * max(r, hypot(fx, fy), hypot(B[0] - cx, B[1] - cy))
    if away > r + slack:
        return None
    if away > r - slack:
        return 0.0
    middle = -(ux * fx + uy * fy)
    far = middle + copysign(sqrt((r - away) * (r + away)), middle)
    power = (hypot(fx, fy) - r) * (hypot(fx, fy) + r)
    return abs(far - power / far)
