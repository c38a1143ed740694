"""A tree of boxes (BVH): halves of the circles by the middle of the longer side, down to four in a leaf.

A ray asks a box where it enters it (slabs in x and y); boxes behind it, beside it or beyond the best hit are left
out with everything in them. Of two children the one that is entered first is visited first, so that the best hit
is found soon and leaves out the more.
"""

from math import hypot, inf, sqrt

LEAF = 4


def build(circles, indices):
    x0 = min(circles[i][0] - circles[i][2] for i in indices)
    x1 = max(circles[i][0] + circles[i][2] for i in indices)
    y0 = min(circles[i][1] - circles[i][2] for i in indices)
    y1 = max(circles[i][1] + circles[i][2] for i in indices)
    if len(indices) <= LEAF:
        return x0, x1, y0, y1, indices, None, None
    axis = 0 if x1 - x0 >= y1 - y0 else 1
    indices = sorted(indices, key=lambda i: circles[i][axis])
    half = len(indices) // 2
    return x0, x1, y0, y1, None, build(circles, indices[:half]), build(circles, indices[half:])


def enters(node, ox, oy, ix, iy, pad):
    """How far along the ray its way through the box begins; infinity where it misses it."""
    if ix is None:
        if not node[0] - pad <= ox <= node[1] + pad:
            return inf
        a, b = -inf, inf
    else:
        a, b = (node[0] - pad - ox) * ix, (node[1] + pad - ox) * ix
        if a > b:
            a, b = b, a
    if iy is None:
        if not node[2] - pad <= oy <= node[3] + pad:
            return inf
    else:
        c, d = (node[2] - pad - oy) * iy, (node[3] + pad - oy) * iy
        if c > d:
            c, d = d, c
        a, b = max(a, c), min(b, d)
    return inf if b < a or b < 0 else max(a, 0.0)


def nearest_hits(circles, rays):
    root = build(circles, list(range(len(circles))))
    xs, ys, rs = zip(*circles)
    low_x, high_x, low_y, high_y, most_r = min(xs), max(xs), min(ys), max(ys), max(rs)
    answers = []
    for (ox, oy), (dx, dy) in rays:
        near = 1e-10 * max(most_r, ox - low_x, high_x - ox, oy - low_y, high_y - oy)
        length = hypot(dx, dy)
        ux, uy = dx / length, dy / length
        ix, iy = (1 / ux if ux else None), (1 / uy if uy else None)
        best, found = inf, None
        stack = [(enters(root, ox, oy, ix, iy, near), root)]
        while stack:
            start, node = stack.pop()
            if start > best or start == inf:
                continue
            if node[4] is None:
                one = (enters(node[5], ox, oy, ix, iy, near), node[5])
                other = (enters(node[6], ox, oy, ix, iy, near), node[6])
                stack += [other, one] if one[0] <= other[0] else [one, other]
                continue
            for i in node[4]:
                x, y, r = circles[i]
                fx, fy = ox - x, oy - y
                d = abs(dx * fy - dy * fx) / length
                if d > r + near:
                    continue
                foot = -(dx * fx + dy * fy) / length
                half = sqrt((r - d) * (r + d)) if d < r - near else 0.0
                for s in (foot - half, foot + half):
                    if s >= -near:
                        if s < best:
                            best, found = s, i
                        break
        answers.append(None if found is None else (found, (best if best > near else 0.0) / length))
    return answers
