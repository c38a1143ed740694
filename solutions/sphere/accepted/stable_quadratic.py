"""stable quadratic

The quadratic in t, its origin first slid along the line to the foot, twice, so that b is next to nothing. Its
roots are taken as q/a and c/q, and what is left of them is added to where the foot is.
"""

from math import copysign, sqrt


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def ray_sphere(C, r, O, D):
    a = dot(D, D)
    if a == 0 or r == 0:
        return None
    f = [o - c for o, c in zip(O, C)]
    size = max(r, *map(abs, f))
    foot, p = 0.0, f
    for _ in range(2):
        step = -dot(p, D) / a
        foot += step
        p = [x + step * d for x, d in zip(p, D)]
    distance = sqrt(dot(p, p))
    if distance > r + 1e-10 * size:
        return None
    if distance >= r - 1e-10 * size:
        found = [(foot, p, 1)]
    else:
        b, c = dot(p, D), (distance - r) * (distance + r)
        q = -(b + copysign(sqrt(b * b - a * c), b))
        both = sorted((q / a, c / q))
        found = [
            (foot + s, [x + s * d for x, d in zip(p, D)], side) for s, side in zip(both, (1, -1))
        ]
    slack = 1e-10 * size / sqrt(a)
    for t, point, side in found:
        if t >= -slack:
            return (0.0 if t <= slack else t), [side * x / r for x in point]
    return None
