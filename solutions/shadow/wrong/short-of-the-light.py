"""short-of-the-light

The way to the light ends a thousandth before the light, so that it does not hit what the light hangs on. A wall may be
as near to L as that: look as far as L.
"""

from math import hypot, sqrt


def roots(px, py, ux, uy, x, y, r):
    """How far along the unit direction u the circle is met, nearer first."""
    gx, gy = x - px, y - py
    s = gx * ux + gy * uy
    d = abs(ux * gy - uy * gx)
    if d >= r:
        return []
    h = sqrt((r - d) * (r + d))
    return [s - h, s + h]


def light(circles, O, D, L):
    ox, oy = O
    n = hypot(*D)
    ux, uy = D[0] / n, D[1] / n
    e = max(max(abs(x - ox), abs(y - oy), r) for x, y, r in circles)
    e = max(e, abs(L[0] - ox), abs(L[1] - oy))
    best = None
    for i, (x, y, r) in enumerate(circles):
        for t in roots(ox, oy, ux, uy, x, y, r):
            if t > 0 and (best is None or t < best[0]):
                best = (t, i)
    if best is None:
        return None
    t, k = best
    px, py = t * ux, t * uy  # seen from O
    lx, ly = L[0] - ox - px, L[1] - oy - py
    x, y, r = circles[k]
    gx, gy = px - (x - ox), py - (y - oy)
    if (lx * gx + ly * gy) * (ux * gx + uy * gy) > 0:
        return "dark"
    far = hypot(lx, ly)
    wx, wy = lx / far, ly / far
    for x, y, r in circles:
        for t in roots(px, py, wx, wy, x - ox, y - oy, r):
            if 1e-8 * e < t < far * 0.999:
                return "dark"
    return "lit"
