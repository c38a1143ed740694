"""equal-cells

The plane is cut into equal square cells, and each beam walks from cell to cell. Circles that crowd fall into few of them.
Sort the circles by their angles instead, which is the order of the beams.
"""

from math import floor, hypot, inf, sqrt


def scan(circles, O, dirs):
    seen = [(x - O[0], y - O[1], r, i) for i, (x, y, r) in enumerate(circles)]
    reach = max(hypot(x, y) + r for x, y, r, i in seen)
    side = 2 * reach / sqrt(len(seen))
    cells = {}
    for x, y, r, i in seen:
        for column in range(floor((x - r) / side), floor((x + r) / side) + 1):
            for row in range(floor((y - r) / side), floor((y + r) / side) + 1):
                cells.setdefault((column, row), []).append((x, y, r, i))
    return [first_hit(cells, side, reach, dx, dy) for dx, dy in dirs]


def first_hit(cells, side, reach, dx, dy):
    length = hypot(dx, dy)
    ux, uy = dx / length, dy / length
    column, row = (-1 if dx < 0 else 0), (-1 if dy < 0 else 0)
    next_x, next_y = (side / abs(each) if each else inf for each in (ux, uy))
    per_x, per_y = next_x, next_y
    best, found, at, near = inf, None, 0.0, 1e-10 * reach
    while at < min(best, reach):
        for x, y, r, i in cells.get((column, row), ()):
            d, middle = abs(ux * y - uy * x), ux * x + uy * y
            if d > r + near or middle < 0:
                continue
            s = middle - (sqrt((r - d) * (r + d)) if d < r - near else 0.0)
            if s < best:
                best, found = s, i
        at = min(next_x, next_y)
        if next_x < next_y:
            column, next_x = column + (1 if dx > 0 else -1), next_x + per_x
        else:
            row, next_y = row + (1 if dy > 0 else -1), next_y + per_y
    return None if found is None else (found, best / length)
