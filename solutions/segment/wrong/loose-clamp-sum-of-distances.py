"""loose-clamp

A point of the line counts as on AB where |PA| + |PB| is |AB| within 5e-7 of the size. Beyond an end by 2e-7 of the
size that sum is only 4e-7 longer. Compare the way along AB with both ends, within 1e-9 of the size.
"""

from math import dist, hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    fx, fy, gx, gy = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    size = max(r, abs(fx), abs(fy), abs(gx), abs(gy))
    near = 1e-10 * size
    dx, dy = B[0] - A[0], B[1] - A[1]
    length = hypot(dx, dy)
    if length == 0:
        return [A] if abs(hypot(fx, fy) - r) <= near else []
    ux, uy = dx / length, dy / length
    side = ux * fy - uy * fx
    gap = abs(side) - r
    if gap > near:
        return []
    half = 0.0 if gap >= -near else sqrt(-gap * (r + abs(side)))
    found = []
    for step in (-half, half) if half else (0.0,):
        P = step * ux - side * uy, step * uy + side * ux
        if dist(P, (fx, fy)) + dist(P, (gx, gy)) <= length + 5e-7 * size:
            found.append((cx + P[0], cy + P[1]))
    return found
