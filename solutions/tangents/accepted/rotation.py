"""rotation

The direction from C to P, turned by the angle whose cosine is r/d: to the right first, which is left from P.

The angle comes from both sides of the triangle, because acos has few digits left where r/d is nearly 1.
"""

from cmath import exp
from math import atan2, sqrt


def tangent_points(cx, cy, r, P):
    f = complex(P[0] - cx, P[1] - cy)
    distance = abs(f)
    threshold = 1e-9 * max(r, abs(f.real), abs(f.imag))
    if r == 0:
        return [(cx, cy)]
    if abs(distance - r) <= threshold:
        return [(P[0], P[1])]
    if distance < r:
        return []
    angle = atan2(sqrt((distance - r) * (distance + r)), r)
    radius = f / distance * r
    found = [radius * exp(sign * angle * 1j) for sign in (-1, 1)]
    return [(cx + each.real, cy + each.imag) for each in found]
