"""quadratic

Every ray asks every circle: n·m tests, four times as many for twice the size. Build a structure over the circles once
(a grid, a tree of boxes), and test only those near the ray's way.
"""

from math import inf, sqrt


def nearest_hits(circles, rays):
    answers = []
    for (ox, oy), (dx, dy) in rays:
        near = 1e-10 * max(max(r, abs(ox - x), abs(oy - y)) for x, y, r in circles)
        length = sqrt(dx * dx + dy * dy)
        best, found = inf, None
        for index, (x, y, r) in enumerate(circles):
            fx, fy = ox - x, oy - y
            d = abs(dx * fy - dy * fx) / length
            if d > r + near:
                continue
            foot = -(dx * fx + dy * fy) / length
            half = sqrt((r - d) * (r + d)) if d < r - near else 0.0
            s = foot - half if foot - half >= -near else foot + half
            if -near <= s < best:
                best, found = s, index
        answers.append(None if found is None else (found, (best if best > near else 0.0) / length))
    return answers
