"""cancellation

b² − c for a direction of length 1 is |f·u|² − |f|² + r²: two squares that are nearly equal when the circle
is small and far away. The cross product gives the distance of the line without a difference.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    foot = -(fx * D[0] + fy * D[1]) / n
    square = foot * foot - (fx * fx + fy * fy - r * r)
    if square < -near * (2 * r + near):
        return None
    half = sqrt(square) if square > near * (2 * r + near) else 0.0
    roots = [foot - half, foot + half]
    for s in roots:
        if s >= -near:
            return 0 if s <= near else s / n
    return None
