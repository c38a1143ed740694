"""An angular sweep: every circle covers an interval of angles, and the beams go through them in order.

Seen from O, outside every disc, circle i covers the angles from θ − α to θ + α, with sin α = r/|C − O|. The starts and
ends are sorted once. With each beam the intervals that have begun by then come in, and those that have ended go. Of the
ones that are in, the circles whose nearest point is closest to O are asked first, from a heap: no other one can be
nearer than its own nearest point.
"""

from heapq import heappop, heappush
from math import asin, atan2, hypot, inf, pi, sqrt

ROOM = 1e-6  # radians around each interval: the test itself is exact enough, this only chooses


def scan(circles, O, dirs):
    ox, oy = O
    near = 1e-10 * max(hypot(x - ox, y - oy) for x, y, r in circles)
    events = []
    for i, (x, y, r) in enumerate(circles):
        fx, fy = x - ox, y - oy
        away = hypot(fx, fy)
        middle, half = atan2(fy, fx), asin(r / away) + ROOM
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
