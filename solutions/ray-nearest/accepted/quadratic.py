"""quadratic

The quadratic in t with the discriminant r²a - k² and the roots that do not cancel.

Why the cross product: by Lagrange's identity r²a - k² equals b² - a·c, but |k| / |D| is the distance
of the line from the centre, which rounding moves by about 1e-16 of the size only, however far away O is.
Whether the ray touches is therefore decided by lengths, before any root is taken.

Why q: near the circle the root of the discriminant is almost |b|, and one of the two textbook roots
subtracts them. q adds them, with the sign of b, and the other root is c / q, because the product of
both is c / a. copysign gives a sign to b = 0 too.

Why the slack is compared with |t|·|D|: t counts in lengths of D, and the tolerance is a length.
A root that close to O means "O is on the circle", whichever side of 0 it was rounded to.
"""

import math


def ray_nearest(cx, cy, r, O, D):
    dx, dy = D
    a = dx * dx + dy * dy
    if a == 0:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    size = max(r, abs(fx), abs(fy))
    length = math.sqrt(a)
    slack = 1e-10 * size

    b = fx * dx + fy * dy
    c = fx * fx + fy * fy - r * r
    k = dx * fy - dy * fx
    gap = abs(k) / length - r
    if gap > slack:
        return None
    if abs(gap) <= slack:
        roots = [-b / a]
    else:
        q = -b - math.copysign(math.sqrt(r * r * a - k * k), b)
        roots = sorted([q / a, c / q])

    for t in roots:
        if abs(t) * length <= slack:
            return 0.0
        if t > 0:
            return t
    return None
