"""sqrt-of-negative

Nothing keeps a line that misses the circle from the root; ** 0.5 of a negative number is complex in Python.
Compare the line's distance with the radius first and return None for a miss.
"""


def ray_nearest(cx, cy, r, O, D):
    dx, dy = D
    fx, fy = O[0] - cx, O[1] - cy
    a = dx * dx + dy * dy
    if a == 0:
        return None
    b = fx * dx + fy * dy
    k = dx * fy - dy * fx
    near = 1e-10 * max(r, abs(fx), abs(fy))
    root = 0.0 if abs(abs(k) / a**0.5 - r) <= near else (r * r * a - k * k) ** 0.5
    for t in ((-b - root) / a, (-b + root) / a):
        if t.real * a**0.5 >= -near:
            return t
    return None
