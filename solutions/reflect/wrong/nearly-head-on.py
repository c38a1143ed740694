"""nearly-head-on

A ray that passes near the centre is sent straight back, as if it went through it. Only the part along the normal turns
round, however small the other one is: R = D − 2(D·N)N.
"""

from math import hypot, sqrt


def reflect(cx, cy, r, O, D):
    (ox, oy), (dx, dy) = O, D
    if r == 0 or (dx == 0 and dy == 0):
        return None
    fx, fy = ox - cx, oy - cy
    e = max(r, abs(fx), abs(fy))
    eps = 1e-10 * e
    n = hypot(dx, dy)
    ux, uy = dx / n, dy / n
    s = -(fx * ux + fy * uy)
    k = ux * fy - uy * fx
    gx, gy = -uy * k, ux * k
    d = abs(k)
    if d > r + eps:
        return None
    if abs(d - r) <= eps:
        if s < -eps:
            return None
        return (cx + gx, cy + gy), (dx, dy)
    h = sqrt((r - d) * (r + d))
    for t in (s - h, s + h):
        if t >= -eps:
            px, py = gx + (t - s) * ux, gy + (t - s) * uy
            nx, ny = px / r, py / r
            if d < 1e-4 * r:
                return (cx + px, cy + py), (-dx, -dy)
            w = 2 * (dx * nx + dy * ny)
            return (cx + px, cy + py), (dx - w * nx, dy - w * ny)
    return None
