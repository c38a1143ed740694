"""slope-intercept

The ray's line is written as y = m·x + n unless it is upright, and t comes from the way along x. A steep ray hardly
moves along x, and that difference has lost its digits. Write the ray as O + t·D, which knows no special direction.
"""

from math import sqrt


def ray_nearest(cx, cy, r, O, D):
    fx, fy = O[0] - cx, O[1] - cy
    dx, dy = D
    if dx == 0:
        if dy == 0:
            return None
        fx, fy, dx, dy = fy, fx, dy, dx  # the same figure in a mirror
    near = 1e-10 * max(r, abs(fx), abs(fy))
    m = dy / dx
    n, long = fy - m * fx, sqrt(1 + m * m)
    d = abs(fy / long - m / long * fx)
    if d > r + near:
        return None
    half = 0.0 if d >= r - near else sqrt((r - d) * (r + d)) / long
    middle = -(m / long) * (n / long)
    for x in (middle - half, middle + half) if dx > 0 else (middle + half, middle - half):
        if (x - fx) / dx * abs(dx) * long >= -near:
            return max(0.0, (x - fx) / dx)
    return None
