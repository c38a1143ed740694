"""foot-for-root

t of the point closest to the centre is returned, as if every hit were a tangency.
Step back from the foot by the half-chord.
"""


def ray_nearest(cx, cy, r, O, D):
    a = D[0] ** 2 + D[1] ** 2
    if a == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    d = abs(D[0] * fy - D[1] * fx) / a**0.5
    if d > r + near:
        return None
    t = -(fx * D[0] + fy * D[1]) / a
    return t if t >= 0 else None
