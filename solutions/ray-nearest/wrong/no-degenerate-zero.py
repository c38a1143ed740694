"""no-degenerate

D = (0, 0) is not looked at, and a length of 0 is replaced by 1 so that nothing is divided by it: a ray
that does not exist gets an answer. Return None before anything else.
"""

from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    fx, fy = O[0] - cx, O[1] - cy
    n = hypot(*D) or 1
    ux, uy = D[0] / n, D[1] / n
    eps = 1e-10 * max(r, abs(fx), abs(fy))
    d = abs(ux * fy - uy * fx) if D[0] or D[1] else hypot(fx, fy)
    if d > r + eps:
        return None
    foot = -(fx * ux + fy * uy)
    if d >= r - eps:
        return max(foot, 0) / n if foot >= -eps else None
    half = sqrt((r - d) * (r + d))
    far = foot + half if foot >= 0 else foot - half
    near = (fx * fx + fy * fy - r * r) / far
    ahead = [s for s in sorted((near, far)) if s >= -eps]
    return (0 if abs(ahead[0]) <= eps else ahead[0] / n) if ahead else None
