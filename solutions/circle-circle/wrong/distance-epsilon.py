"""distance-epsilon

The threshold is a fraction of the distance of the centres. Close centres with large radii have a wider band: measure it
by the extent, the largest of both radii and of the parts of C2 − C1.
"""

from math import hypot, sqrt


def circle_circle(cx1, cy1, r1, cx2, cy2, r2):
    vx, vy = cx2 - cx1, cy2 - cy1
    d = hypot(vx, vy)
    eps = 1e-10 * d
    largest = max(r1, r2, d)
    if d <= 1e-10 * largest:
        if abs(r1 - r2) > 1e-10 * largest:
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
    h = sqrt((d + r1 + r2) * (r1 + r2 - d) * (d + r1 - r2) * (d - r1 + r2)) / (2 * d)
    mx, my = a * ux, a * uy
    return [(cx1 + mx - h * uy, cy1 + my + h * ux), (cx1 + mx + h * uy, cy1 + my - h * ux)]
