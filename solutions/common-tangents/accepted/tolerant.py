"""normals, with a tolerance

A tangent has a unit normal n, and both centres' distances from it are the radii: n·v = r1 − r2, or r1 + r2.

With C1 on the one side of the tangent and X·n = r1 its equation as seen from C1, the other centre v is r2 away from
it: v·n = r1 − r2 on the same side (outer tangents), or r1 + r2 beyond it (inner ones). Call that q. n is q/d along
v/d, and √(1 − q²/d²) beside it, to the left or to the right. The point is C1 + r1·n.

Both are one where d = |q|, and there are none where d < |q|: no case needs more than that.
"""

from math import hypot, sqrt


def common_tangents(cx1, cy1, r1, cx2, cy2, r2):
    vx, vy = cx2 - cx1, cy2 - cy1
    near = 1e-9 * max(r1, r2, abs(vx), abs(vy))
    d = hypot(vx, vy)
    ux, uy = vx / d, vy / d
    found = []
    for q in (r1 - r2, r1 + r2):
        gap = d - abs(q)
        if gap < -near:
            continue
        if gap <= near:
            c, heights = (1 if q > 0 else -1), (0,)
        else:
            c, h = q / d, sqrt((d - q) * (d + q)) / d
            heights = (h, -h)
        found += [(cx1 + r1 * (c * ux - s * uy), cy1 + r1 * (c * uy + s * ux)) for s in heights]
    return found
