"""The tree of boxes as a program: it reads the number of scenes and prints a line for each."""

import sys
from math import hypot, inf, sqrt


def main():
    numbers = iter(map(int, sys.stdin.read().split()))
    lines = []
    for _ in range(next(numbers)):
        circles = [(next(numbers), next(numbers), next(numbers)) for _ in range(next(numbers))]
        rays = [tuple([next(numbers) for _ in range(4)]) for _ in range(next(numbers))]
        parts = [str(len(rays))]
        for hit in scene(circles, rays):
            parts.append("none" if hit is None else f"{hit[0]} {hit[1]!r}")
        lines.append(" ".join(parts))
    print("\n".join(lines))


def build(circles, indices):
    x0 = min([circles[i][0] - circles[i][2] for i in indices])
    x1 = max([circles[i][0] + circles[i][2] for i in indices])
    y0 = min([circles[i][1] - circles[i][2] for i in indices])
    y1 = max([circles[i][1] + circles[i][2] for i in indices])
    if len(indices) <= 4:
        return x0, x1, y0, y1, indices, None, None
    axis, half = (0 if x1 - x0 >= y1 - y0 else 1), len(indices) // 2
    indices = sorted(indices, key=lambda i: circles[i][axis])
    return x0, x1, y0, y1, None, build(circles, indices[:half]), build(circles, indices[half:])


def scene(circles, rays):
    root = build(circles, list(range(len(circles))))
    xs, ys, rs = zip(*circles)
    x0, x1, y0, y1, most = min(xs), max(xs), min(ys), max(ys), max(rs)
    for ox, oy, dx, dy in rays:
        near = 1e-10 * max(most, ox - x0, x1 - ox, oy - y0, y1 - oy)
        length = hypot(dx, dy)
        ux, uy = dx / length or 1e-300, dy / length or 1e-300

        def enters(box):
            a, b = (box[0] - near - ox) / ux, (box[1] + near - ox) / ux
            c, d = (box[2] - near - oy) / uy, (box[3] + near - oy) / uy
            start = max(0.0, min(a, b), min(c, d))
            return start if start <= min(max(a, b), max(c, d)) else inf

        best, found, stack = inf, None, [(enters(root), root)]
        while stack:
            start, box = stack.pop()
            if start == inf or start > best:
                continue
            if box[4] is None:
                one, other = (enters(box[5]), box[5]), (enters(box[6]), box[6])
                stack += (other, one) if one[0] <= other[0] else (one, other)
                continue
            for index in box[4]:
                x, y, r = circles[index]
                d = abs(dx * (y - oy) - dy * (x - ox)) / length
                if d > r + near:
                    continue
                foot = (dx * (x - ox) + dy * (y - oy)) / length
                half = sqrt((r - d) * (r + d)) if d < r - near else 0.0
                way = foot - half if foot - half >= -near else foot + half
                if -near <= way < best:
                    best, found = way, index
        yield None if found is None else (found, best / length if best > near else 0.0)


main()
