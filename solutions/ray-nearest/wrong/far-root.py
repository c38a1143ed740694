"""far-root

The greater root is returned where the lesser one is ahead as well.
Try the lesser root first.
"""

import math


def ray_nearest(cx, cy, r, O, D):
    dx, dy = D
    fx, fy = O[0] - cx, O[1] - cy
    a = dx * dx + dy * dy
    if a == 0:
        return None
    slack = 1e-10 * max(r, abs(fx), abs(fy)) / math.sqrt(a)
    b = fx * dx + fy * dy
    k = dx * fy - dy * fx
    gap = (r - abs(k) / math.sqrt(a)) / math.sqrt(a)
    if gap < -slack:
        return None
    root = math.sqrt(r * r * a - k * k) if gap > slack else 0.0
    t = (-b + root) / a
    if t < -slack:
        return None
    return t if t > slack else 0.0
