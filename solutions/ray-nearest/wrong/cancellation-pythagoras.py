"""cancellation

The distance of the line is the root of |f|² − m², two squares that are nearly equal when the circle is
small and far away. The cross product gives it without a difference: |D × f| / |D|.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    foot = -(fx * D[0] + fy * D[1]) / n
    d = sqrt(max(0.0, fx * fx + fy * fy - foot * foot))
    if d > r + near:
        return None
    if d >= r - near:
        roots = [foot]
    else:
        half = sqrt((r - d) * (r + d))
        far = foot + half if foot > 0 else foot - half
        roots = sorted([far, (fx * fx + fy * fy - r * r) / far])
    for s in roots:
        if s >= -near:
            return 0 if s <= near else s / n
    return None
