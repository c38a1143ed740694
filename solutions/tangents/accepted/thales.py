"""Thales

The points see the segment from C to P under a right angle: they are on the circle around its middle, too.

Both circles are cut as two circles are: subtract their equations, and cut the line that is left.
"""

from math import sqrt


def tangent_points(cx, cy, r, P):
    px, py = P[0] - cx, P[1] - cy
    size = max(r, abs(px), abs(py))
    if r == 0:
        return [[cx, cy]]
    px, py, q = px / size, py / size, r / size
    square = px * px + py * py
    gap = (square - q * q) / (sqrt(square) + q)
    if gap < -1e-9:
        return []
    if gap <= 1e-9:
        return [[P[0], P[1]]]
    # |X|² = q² and |X − M|² = |M|² with M = P/2: their difference is the line X·P = q².
    mx, my = px / 2, py / 2
    reach = q * q / (2 * (mx * mx + my * my))
    fx, fy = reach * mx, reach * my
    half = sqrt(q * q - fx * fx - fy * fy) if gap > 1e-3 else q * sqrt(gap * (gap + 2 * q) / square)
    ux, uy = py / sqrt(square), -px / sqrt(square)
    return [[cx + size * (fx + s * half * ux), cy + size * (fy + s * half * uy)] for s in (1, -1)]
