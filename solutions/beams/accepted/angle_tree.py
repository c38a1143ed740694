"""A tree over the beams: each circle is put where its interval of angles is, and each beam looks up its ancestors.

The beams' angles are sorted, so a circle covers a run of them, found by bisection. A segment tree cuts the run into at
most 2·log n nodes, and the circle goes into the list of each. A beam finds its candidates in the lists from its leaf up
to the root, sorted by the distance of their nearest points, and stops in each list where no better one can follow.
"""

from bisect import bisect_left, bisect_right
from math import asin, atan2, hypot, inf, pi, sqrt


def scan(circles, O, dirs):
    ox, oy = O
    angles = [atan2(dy, dx) for dx, dy in dirs]
    size = 1
    while size < len(dirs):
        size *= 2
    lists = [[] for _ in range(2 * size)]
    shapes = sorted((hypot(x - ox, y - oy) - r, x - ox, y - oy, r, i) for i, (x, y, r) in enumerate(circles))
    for shape in shapes:  # the nearest first, so that every list is sorted
        least, fx, fy, r, i = shape
        middle, half = atan2(fy, fx), asin(r / hypot(fx, fy)) + 1e-6
        for turn in (-2 * pi, 0, 2 * pi):
            first = bisect_left(angles, middle + turn - half) + size
            after = bisect_right(angles, middle + turn + half) + size
            while first < after:
                if first & 1:
                    lists[first].append(shape)
                    first += 1
                if after & 1:
                    after -= 1
                    lists[after].append(shape)
                first, after = first // 2, after // 2
    near = 1e-10 * max(least + r for least, fx, fy, r, i in shapes)
    answers = []
    for place, (dx, dy) in enumerate(dirs):
        length = hypot(dx, dy)
        best, found = inf, None
        node = place + size
        while node:
            for least, fx, fy, r, i in lists[node]:
                if least > best:
                    break
                d = abs(dx * fy - dy * fx) / length
                if d > r + near:
                    continue
                s = (dx * fx + dy * fy) / length - (sqrt((r - d) * (r + d)) if d < r - near else 0.0)
                if s < best:
                    best, found = s, i
            node //= 2
        answers.append(None if found is None else (found, best / length))
    return answers
