"""distance

The distance of P from the centre against the radius, within a small part of the extent.

Everything is seen from the centre, so that a small circle far from the origin keeps its digits. The
distance is the hypotenuse of the triangle with the sides |fx| and |fy|. It is known to about 1e-16 of
itself, the band is 1e-12 of the extent, and nothing else is nearer than 1e-7 of it: so any threshold
between them decides rightly, and 1e-10 of the extent has room on both sides.
"""

from math import hypot


def on_circle(cx, cy, r, P):
    fx, fy = P[0] - cx, P[1] - cy
    extent = max(r, abs(fx), abs(fy))
    gap = hypot(fx, fy) - r
    if abs(gap) <= 1e-10 * extent:
        return 0
    return 1 if gap > 0 else -1
