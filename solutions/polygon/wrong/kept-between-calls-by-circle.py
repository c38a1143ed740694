"""kept-between-calls

The crossings are kept under the circle and how many corners there are: another polygon gets those of the first. Make
all arguments the key, or keep nothing.
"""

from math import hypot, sqrt


def boundary_hits(cx, cy, r, V, known={}):
    key = cx, cy, r, len(V)
    if key not in known:
        known[key] = crossings(cx, cy, r, V)
    return known[key]


def crossings(cx, cy, r, V):
    near = 1e-10 * max(r, *(max(abs(x - cx), abs(y - cy)) for x, y in V))
    found = []
    for i, (x, y) in enumerate(V):
        dx, dy = V[i - len(V) + 1][0] - x, V[i - len(V) + 1][1] - y
        size = hypot(dx, dy)
        dx, dy = dx / size, dy / size
        foot, d = dx * (cx - x) + dy * (cy - y), abs(dx * (cy - y) - dy * (cx - x))
        if d <= r + near:
            half = sqrt((r - d) * (r + d)) if d < r - near else 0
            for way in {foot - half: 0, foot + half: 0}:
                if -near <= way < size - near:
                    found.append((i, (x + way * dx, y + way * dy)))
    return found
