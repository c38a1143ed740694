"""A packed tree with the widest tolerance: circles are sorted into tiles of eight, and tiles into tiles of eight.

Sorted by x and cut into upright slices, each of them sorted by y, circles that follow one another are close together.
Eight of them share a box, eight boxes the next one, up to one for all. Lengths are compared with 1e-8 of the size.
"""

from math import hypot, inf, sqrt

PER = 8


def packed(boxes):
    """Boxes (x0, x1, y0, y1, what), eight to a parent."""
    while len(boxes) > 1:
        boxes.sort(key=lambda box: box[0] + box[1])
        slices = max(1, round((len(boxes) / PER) ** 0.5))
        size = -(-len(boxes) // slices)
        parents = []
        for at in range(0, len(boxes), size):
            slice_ = sorted(boxes[at : at + size], key=lambda box: box[2] + box[3])
            for first in range(0, len(slice_), PER):
                tile = slice_[first : first + PER]
                x0, x1, y0, y1, _ = zip(*tile)
                parents.append((min(x0), max(x1), min(y0), max(y1), tile))
        boxes = parents
    return boxes[0]


def nearest_hits(circles, rays):
    root = packed([(x - r, x + r, y - r, y + r, i) for i, (x, y, r) in enumerate(circles)])
    if isinstance(root[4], int):
        root = (*root[:4], [root])
    xs, ys, rs = zip(*circles)
    x0, x1, y0, y1, most = min(xs), max(xs), min(ys), max(ys), max(rs)
    answers = []
    for (ox, oy), (dx, dy) in rays:
        near = 1e-8 * max(most, ox - x0, x1 - ox, oy - y0, y1 - oy)
        length = hypot(dx, dy)
        ux, uy = dx / length or 1e-300, dy / length or 1e-300
        best, found, stack = inf, None, [(0.0, root[4])]
        while stack:
            start, tile = stack.pop()
            if start > best:
                continue
            inner = []
            for left, right, low, high, what in tile:
                a, b = (left - near - ox) / ux, (right + near - ox) / ux
                c, d = (low - near - oy) / uy, (high + near - oy) / uy
                start = max(0.0, min(a, b), min(c, d))
                if start > best or start > min(max(a, b), max(c, d)):
                    continue
                if not isinstance(what, int):
                    inner.append((start, what))
                    continue
                x, y, r = circles[what]
                across = abs(dx * (y - oy) - dy * (x - ox)) / length
                if across > r + near:
                    continue
                foot = (dx * (x - ox) + dy * (y - oy)) / length
                half = sqrt((r - across) * (r + across)) if across < r - near else 0.0
                way = foot - half if foot - half >= -near else foot + half
                if -near <= way < best:
                    best, found = way, what
            stack += sorted(inner, key=lambda each: -each[0])
        answers.append(None if found is None else (found, best / length if best > near else 0.0))
    return answers
