"""kept-between-calls

The angles of the circles are kept for the next call with as many circles, which are others by then. Compute them in
every call.
"""

from math import asin, atan2, hypot, inf, pi, sqrt

known = {}


def scan(circles, O, dirs):
    ox, oy = O
    near = 1e-10 * max(max(r, abs(x - ox), abs(y - oy)) for x, y, r in circles)
    if len(circles) not in known:
        known[len(circles)] = intervals(circles, O)
    events = known[len(circles)]
    answers, inside, at = [], [], 0
    for dx, dy in dirs:
        angle, length = atan2(dy, dx), hypot(dx, dy)
        while at < len(events) and events[at][0] <= angle:
            inside.append(events[at][1:])
            at += 1
        inside = [each for each in inside if each[0] >= angle]
        best, found = inf, None
        for _, i in inside:
            x, y, r = circles[i]
            fx, fy = x - ox, y - oy
            d = abs(dx * fy - dy * fx) / length
            if d <= r + near:
                s = (dx * fx + dy * fy) / length - (sqrt((r - d) * (r + d)) if d < r - near else 0.0)
                if 0 <= s < best:
                    best, found = s, i
        answers.append(None if found is None else (found, best / length))
    return answers


def intervals(circles, O):
    found = []
    for i, (x, y, r) in enumerate(circles):
        fx, fy = x - O[0], y - O[1]
        middle, half = atan2(fy, fx), asin(r / hypot(fx, fy)) + 1e-9
        found += [(middle + turn - half, middle + turn + half, i) for turn in (-2 * pi, 0, 2 * pi)]
    return sorted(found)
