"""tangent and normal

D is taken apart along the tangent and along the normal, and put together again with the second part turned round. The
point is found by the quadratic, with the root that does not cancel.
"""

from math import copysign, hypot, sqrt


def reflect(cx, cy, r, O, D):
    dx, dy = D
    fx, fy = O[0] - cx, O[1] - cy
    a = dx * dx + dy * dy
    if not (a and r):
        return None
    e, size = max(r, abs(fx), abs(fy)), sqrt(a)
    b, c = fx * dx + fy * dy, (hypot(fx, fy) - r) * (hypot(fx, fy) + r)
    k = abs(dx * fy - dy * fx)
    if k / size - r > 1e-10 * e:
        return None
    if k / size - r >= -1e-10 * e:
        roots = [-b / a]
    else:
        q = -b - copysign(sqrt((r * size - k) * (r * size + k)), b)
        roots = sorted((q / a, c / q))
    for t in roots:
        if t * size > -1e-10 * e:
            gx, gy = (fx + t * dx) / r, (fy + t * dy) / r
            along, across = dx * gx + dy * gy, dy * gx - dx * gy
            return (O[0] + t * dx, O[1] + t * dy), (-along * gx - across * gy, -along * gy + across * gx)
    return None
