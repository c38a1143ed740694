"""polar, with a tolerance

The polar of P, the line through both points: its foot from C, and half its chord.

The tangent is at right angles to the radius, so C, P and a point T where it touches are a right triangle with
the longest side d = |P − C|. The foot of T on the line from C to P is r²/d away from C, and T is r·h/d beside
it, where h = √(d² − r²) is the tangent's length.

Three cases come first: inside, on the circle, outside. They are told apart by lengths, d against r, within 1e-9
of the size. The left of P→C is the right of C→P: (fy, −fx).
"""

from math import hypot, sqrt


def tangent_points(cx, cy, r, P):
    if r == 0:
        return [(cx, cy)]
    fx, fy = P[0] - cx, P[1] - cy
    near = 1e-9 * max(r, abs(fx), abs(fy))
    d = hypot(fx, fy)
    if d < r - near:
        return []
    if d <= r + near:
        return [P]
    h = sqrt((d - r) * (d + r))
    along, beside = (r / d) ** 2, (r / d) * (h / d)
    return [
        (cx + along * fx + beside * fy, cy + along * fy - beside * fx),
        (cx + along * fx - beside * fy, cy + along * fy + beside * fx),
    ]
