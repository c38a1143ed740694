"""squared distance

The squared distance of the centres is a quadratic in t: a·t² + 2·b·t + c + R² with R = r + s. The first root of
a·t² + 2·b·t + c is c / (−b + √Δ), a division of what does not cancel, for where the discs come nearer b is negative.
"""

from math import hypot, sqrt


def balls_meet(P0, P1, r, Q0, Q1, s):
    reach = r + s
    f = [a - b for a, b in zip(P0, Q0)]
    v = [(b - a) - (d - c) for a, b, c, d in zip(P0, P1, Q0, Q1)]
    size = max([reach] + [abs(z - a) for q in (P1, Q0, Q1) for z, a in zip(q, P0)])
    near = 1e-10 * size
    away = hypot(*f)
    if away <= reach + near:
        return 0.0
    a = v[0] * v[0] + v[1] * v[1]
    b = v[0] * f[0] + v[1] * f[1]
    if b >= 0:
        return None
    k = v[0] * f[1] - v[1] * f[0]
    disc = reach * reach * a - k * k
    room = near * (2 * reach + near) * a
    if disc < -room:
        return None
    c = (away - reach) * (away + reach)
    t = -b / a if disc <= room else c / (-b + sqrt(disc))
    return t if (t - 1) * sqrt(a) <= near else None
