"""The angular sweep as a program: it reads the number of scenes and prints a line for each."""

import sys
from heapq import heappop, heappush
from math import asin, atan2, hypot, inf, pi, sqrt


def main():
    numbers = iter(map(int, sys.stdin.read().split()))
    for _ in range(next(numbers)):
        circles = [(next(numbers), next(numbers), next(numbers)) for _ in range(next(numbers))]
        origin = next(numbers), next(numbers)
        dirs = [(next(numbers), next(numbers)) for _ in range(next(numbers))]
        found = seen(circles, origin, dirs)
        print(len(found), *("none" if hit is None else f"{hit[0]} {hit[1]!r}" for hit in found))


def seen(circles, O, dirs):
    ox, oy = O
    near = 1e-10 * max(hypot(x - ox, y - oy) for x, y, r in circles)
    events = []
    for i, (x, y, r) in enumerate(circles):
        fx, fy = x - ox, y - oy
        away = hypot(fx, fy)
        middle, half = atan2(fy, fx), asin(r / away) + 1e-6
        for turn in (-2 * pi, 0.0, 2 * pi):
            start, end = middle + turn - half, middle + turn + half
            if end >= -pi and start <= pi:
                events.append((start, end, away - r, fx, fy, r, i))
    events.sort(reverse=True)
    heap, answers = [], []
    for dx, dy in dirs:
        angle = atan2(dy, dx)
        while events and events[-1][0] <= angle:
            start, end, least, fx, fy, r, i = events.pop()
            heappush(heap, (least, i, end, fx, fy, r))
        length = hypot(dx, dy)
        ux, uy = dx / length, dy / length
        best, found, back = inf, None, []
        while heap and heap[0][0] <= best:
            item = heappop(heap)
            least, i, end, fx, fy, r = item
            if end < angle:
                continue
            back.append(item)
            d = abs(ux * fy - uy * fx)
            if d > r + near:
                continue
            s = ux * fx + uy * fy - (sqrt((r - d) * (r + d)) if d < r - near else 0.0)
            if s < best:
                best, found = s, i
        for item in back:
            heappush(heap, item)
        answers.append(None if found is None else (found, best / length))
    return answers


main()
