"""equal-cells

The plane is cut into equal square cells, as many as there are circles, and each ray walks from cell to cell. Circles that
crowd fall into few cells, and each ray there asks all of them. Part the circles, not the plane: a tree of boxes.
"""

from math import inf, sqrt


def nearest_hits(circles, rays):
    left = min(x - r for x, y, r in circles)
    low = min(y - r for x, y, r in circles)
    wide = max(x + r for x, y, r in circles) - left
    tall = max(y + r for x, y, r in circles) - low
    side = max(1.0, 1.5 * sqrt(wide * tall / len(circles)), max(wide, tall) / 1000)
    columns, rows = int(wide / side) + 1, int(tall / side) + 1
    cells = {}
    for index, (x, y, r) in enumerate(circles):
        last_row = int((y + r - low) / side)
        for column in range(int((x - r - left) / side), int((x + r - left) / side) + 1):
            for row in range(int((y - r - low) / side), last_row + 1):
                cells.setdefault((column, row), []).append(index)
    box = (min(c[0] for c in circles), max(c[0] for c in circles), min(c[1] for c in circles),
           max(c[1] for c in circles), max(c[2] for c in circles))
    return [first_hit(circles, cells, (left, low, side, columns, rows), box, ray) for ray in rays]


def first_hit(circles, cells, grid, box, ray):
    (ox, oy), (dx, dy) = ray
    left, low, side, columns, rows = grid
    near = 1e-10 * max(box[4], ox - box[0], box[1] - ox, oy - box[2], box[3] - oy)
    length = sqrt(dx * dx + dy * dy)
    # Where the ray is within the grid.
    enter, leave = 0.0, inf
    for o, d, start, size in ((ox, dx, left, columns * side), (oy, dy, low, rows * side)):
        if d:
            a, b = (start - o) / d, (start + size - o) / d
            enter, leave = max(enter, min(a, b)), min(leave, max(a, b))
        elif not start <= o <= start + size:
            return None
    if enter > leave:
        return None
    column = min(columns - 1, max(0, int((ox + enter * dx - left) // side)))
    row = min(rows - 1, max(0, int((oy + enter * dy - low) // side)))
    right, up = (1 if dx > 0 else -1), (1 if dy > 0 else -1)
    to_column = (left + (column + (dx > 0)) * side - ox) / dx if dx else inf
    to_row = (low + (row + (dy > 0)) * side - oy) / dy if dy else inf
    per_column = side / abs(dx) if dx else inf
    per_row = side / abs(dy) if dy else inf
    best, found = inf, None
    while 0 <= column < columns and 0 <= row < rows:
        for index in cells.get((column, row), ()):
            x, y, r = circles[index]
            fx, fy = x - ox, y - oy
            gap = abs(dx * fy - dy * fx) / length - r
            if gap > near:
                continue
            middle = (dx * fx + dy * fy) / length
            half = sqrt(-gap * (gap + r + r)) if gap < -near else 0.0
            t = middle - half
            if t < -near:
                t = middle + half
                if t < -near:
                    continue
            if t < best:
                best, found = (t if t > near else 0.0), index
        border = min(to_column, to_row)
        if best <= border * length:
            break
        if to_column < to_row:
            column, to_column = column + right, to_column + per_column
        else:
            row, to_row = row + up, to_row + per_row
    return None if found is None else (found, best / length)
