"""sign-of-zero

Where f·D is 0 the sign of the stable formula is 0, and the root that is found from the other one is all
there is. Take the sign of 0 as +1 (or use copysign).
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    d = abs(D[0] * fy - D[1] * fx) / n
    foot = -(fx * D[0] + fy * D[1]) / n
    if d > r + near:
        return None
    if d >= r - near:
        roots = [foot]
    else:
        far = foot + ((foot > 0) - (foot < 0)) * sqrt((r - d) * (r + d))
        roots = sorted([far, (fx * fx + fy * fy - r * r) / far if far else 0.0])
    for s in roots:
        if s >= -near:
            return 0 if s <= near else s / n
    return None
