"""radical-line-divided

The line through both points is solved for y, which divides by cy2 − cy1. Where that is next to nothing, the quotient is
next to endless and the digits are gone. Go from C1 along C2 − C1 and across it, and divide by d only.
"""

from math import hypot, sqrt


def circle_circle(cx1, cy1, r1, cx2, cy2, r2):
    vx, vy = cx2 - cx1, cy2 - cy1
    d = hypot(vx, vy)
    eps = 1e-10 * max(r1, r2, abs(vx), abs(vy))
    if d <= eps:
        if abs(r1 - r2) > eps:
            return []
        return None if r1 > 0 else [(cx1, cy1)]
    ux, uy = vx / d, vy / d
    if abs(d - (r1 + r2)) <= eps:
        return [(cx1 + r1 * ux, cy1 + r1 * uy)]
    if abs(d - abs(r1 - r2)) <= eps:
        side = r1 if r1 > r2 else -r1
        return [(cx1 + side * ux, cy1 + side * uy)]
    if d > r1 + r2 or d < abs(r1 - r2):
        return []
    a = (d + (r1 - r2) * (r1 + r2) / d) / 2
    if vy == 0:
        h = sqrt((d + r1 + r2) * (r1 + r2 - d) * (d + r1 - r2) * (d - r1 + r2)) / (2 * d)
        return [(cx1 + a * ux, cy1 + h * ux), (cx1 + a * ux, cy1 - h * ux)]
    # y = w - k x on the radical line
    k, w = vx / vy, a * d / vy
    middle = k * w / (1 + k * k)
    root = sqrt(max(0.0, middle * middle - (w * w - r1 * r1) / (1 + k * k)))
    left, right = (middle - root, middle + root) if vy > 0 else (middle + root, middle - root)
    return [(cx1 + left, cy1 + w - k * left), (cx1 + right, cy1 + w - k * right)]
