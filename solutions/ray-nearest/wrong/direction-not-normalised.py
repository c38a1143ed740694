"""direction-not-normalised

The formula for |D| = 1 is used with a D of any length: t² + 2bt + c = 0 lacks its a.
Divide by a = D·D, or normalise D and divide t by its length afterwards.
"""

from math import sqrt


def ray_nearest(cx, cy, r, O, D):
    if D[0] == 0 and D[1] == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    b = fx * D[0] + fy * D[1]
    c = fx * fx + fy * fy - r * r
    disc = b * b - c
    if disc < 0:
        return None
    near = 1e-10 * max(r, abs(fx), abs(fy))
    for t in (-b - sqrt(disc), -b + sqrt(disc)):
        if t >= -near:
            return max(t, 0)
    return None
