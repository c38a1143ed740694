"""small-parts-dropped

A part of the direction that is small beside the others is taken for rounding and set to 0. Far along the ray it is a
way: leave D as it is.
"""

from math import hypot, sqrt


def ray_sphere(C, r, O, D):
    n = hypot(*D)
    if r == 0 or n == 0:
        return None
    fx, fy, fz = (O[i] - C[i] for i in range(3))
    ux, uy, uz = (D[i] / n if abs(D[i]) > 1e-7 * n else 0.0 for i in range(3))
    eps = 1e-10 * max(r, abs(fx), abs(fy), abs(fz))
    s = -(fx * ux + fy * uy + fz * uz)
    kx, ky, kz = uy * fz - uz * fy, uz * fx - ux * fz, ux * fy - uy * fx
    d = hypot(kx, ky, kz)
    # foot of the perpendicular from C: k x u
    gx, gy, gz = ky * uz - kz * uy, kz * ux - kx * uz, kx * uy - ky * ux
    if d > r + eps:
        return None
    if d >= r - eps:
        if s < -eps:
            return None
        t = max(s, 0.0)
        return t / n, (gx / d, gy / d, gz / d)
    h = sqrt((r - d) * (r + d))
    if s - h >= -eps:
        t, side, sign = s - h, -h, 1
    elif s + h >= -eps:
        t, side, sign = s + h, h, -1
    else:
        return None
    if abs(t) <= eps:
        t = 0.0
    N = [sign * (g + side * u) / r for g, u in ((gx, ux), (gy, uy), (gz, uz))]
    return t / n, tuple(N)
