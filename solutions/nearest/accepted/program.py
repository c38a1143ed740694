"""The grid as a program: it reads the number of scenes and prints a line for each."""

import sys
from math import inf, sqrt


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


def scene(circles, rays):
    left, right = min(x - r for x, _, r in circles), max(x + r for x, _, r in circles)
    low, high = min(y - r for _, y, r in circles), max(y + r for _, y, r in circles)
    side = max(1.0, 1.5 * sqrt((right - left) * (high - low) / len(circles)), (right - left) / 1000, (high - low) / 1000)
    cells = {}
    for index, (x, y, r) in enumerate(circles):
        for column in range(int((x - r - left) / side), int((x + r - left) / side) + 1):
            for row in range(int((y - r - low) / side), int((y + r - low) / side) + 1):
                cells.setdefault((column, row), []).append(index)
    columns, rows = int((right - left) / side) + 1, int((high - low) / side) + 1
    xs, ys, rs = zip(*circles)
    x0, x1, y0, y1, most = min(xs), max(xs), min(ys), max(ys), max(rs)
    for ox, oy, dx, dy in rays:
        near = 1e-10 * max(most, ox - x0, x1 - ox, oy - y0, y1 - oy)
        length = sqrt(dx * dx + dy * dy)
        ux, uy = dx / length, dy / length
        start, end = 0.0, inf
        for o, u, least, count in ((ox, ux, left, columns), (oy, uy, low, rows)):
            if u:
                one, other = sorted(((least - o) / u, (least + count * side - o) / u))
                start, end = max(start, one), min(end, other)
            elif not least <= o <= least + count * side:
                end = -inf
        best, found = inf, None
        if start <= end:
            column = max(0, min(columns - 1, int((ox + start * ux - left) / side)))
            row = max(0, min(rows - 1, int((oy + start * uy - low) / side)))
            next_x = (left + (column + (ux > 0)) * side - ox) / ux if ux else inf
            next_y = (low + (row + (uy > 0)) * side - oy) / uy if uy else inf
            while 0 <= column < columns and 0 <= row < rows:
                for index in cells.get((column, row), ()):
                    x, y, r = circles[index]
                    d = abs(ux * (y - oy) - uy * (x - ox))
                    if d > r + near:
                        continue
                    foot = ux * (x - ox) + uy * (y - oy)
                    half = sqrt((r - d) * (r + d)) if d < r - near else 0.0
                    s = foot - half if foot - half >= -near else foot + half
                    if -near <= s < best:
                        best, found = s, index
                if best <= min(next_x, next_y):
                    break
                if next_x < next_y:
                    column += 1 if ux > 0 else -1
                    next_x += side / abs(ux)
                else:
                    row += 1 if uy > 0 else -1
                    next_y += side / abs(uy)
        yield None if found is None else (found, max(0.0, best) / length if best > near else 0.0)


main()
