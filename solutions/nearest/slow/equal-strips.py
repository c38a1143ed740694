"""equal-strips

The plane is cut into equal strips along x, or along y, and in each of them the circles are sorted. Circles that crowd in
a narrow place fall into few strips. Part the circles, not the plane: a tree of boxes.
"""

from bisect import bisect_left, bisect_right
from math import inf, sqrt


class Strips:
    def __init__(self, circles, axis):
        self.axis = axis
        self.low = min(c[axis] - c[2] for c in circles)
        high = max(c[axis] + c[2] for c in circles)
        across = max(c[1 - axis] + c[2] for c in circles) - min(c[1 - axis] - c[2] for c in circles)
        self.side = max(1.0, 1.2 * sqrt((high - self.low) * across / len(circles)), (high - self.low) / 2000)
        self.count = int((high - self.low) / self.side) + 1
        strips = [[] for _ in range(self.count)]
        for index, c in enumerate(circles):
            first, last = (int((c[axis] + s * c[2] - self.low) / self.side) for s in (-1, 1))
            for place in range(first, last + 1):
                strips[place].append((c[1 - axis], index))
        self.strips = []
        for strip in strips:
            strip.sort()
            # Large circles would make every search wide: they have a list of their own.
            radii = sorted(circles[i][2] for _, i in strip)
            usual = 2 * radii[len(radii) // 2] if radii else 0
            large = [i for _, i in strip if circles[i][2] > usual]
            small = [(at, i) for at, i in strip if circles[i][2] <= usual]
            self.strips.append(([at for at, _ in small], [i for _, i in small], usual, large))

    def along(self, o, d):
        """(t at which the ray leaves, candidates) of each strip on its way."""
        main, side = self.axis, 1 - self.axis
        start = (self.low - o[main]) / d[main]
        end = (self.low + self.count * self.side - o[main]) / d[main]
        t = max(0.0, min(start, end))
        if max(start, end) < 0:
            return
        place = int((o[main] + t * d[main] - self.low) / self.side)
        step = 1 if d[main] > 0 else -1
        place = max(0, min(self.count - 1, place))
        while 0 <= place < self.count:
            border = self.low + (place + (step > 0)) * self.side
            after = (border - o[main]) / d[main]
            here, there = o[side] + t * d[side], o[side] + after * d[side]
            ats, indices, most, large = self.strips[place]
            reach = most + 1
            first = bisect_left(ats, min(here, there) - reach)
            last = bisect_right(ats, max(here, there) + reach)
            yield after, indices[first:last], large
            t, place = after, place + step


def nearest_hits(circles, rays):
    upright, level = Strips(circles, 0), Strips(circles, 1)
    xs, ys, rs = zip(*circles)
    reaches = (min(xs), max(xs), min(ys), max(ys), max(rs))
    answers = []
    for o, d in rays:
        strips = upright if abs(d[0]) >= abs(d[1]) else level
        answers.append(first_hit(circles, strips, o, d, reaches))
    return answers


def first_hit(circles, strips, o, d, reaches):
    (ox, oy), (dx, dy) = o, d
    x0, x1, y0, y1, most = reaches
    near = 1e-10 * max(most, ox - x0, x1 - ox, oy - y0, y1 - oy)
    a = dx * dx + dy * dy
    length = sqrt(a)
    best, found = inf, None
    for after, *lists in strips.along(o, d):
        for indices in lists:
            for index in indices:
                x, y, r = circles[index]
                fx, fy = ox - x, oy - y
                k = dx * fy - dy * fx
                distance = abs(k) / length
                if distance > r + near:
                    continue
                b = dx * fx + dy * fy
                delta = r * r * a - k * k
                root = sqrt(delta) if distance < r - near and delta > 0 else 0.0
                for t in ((-b - root) / a, (-b + root) / a):
                    if t * length >= -near:
                        if (t, index) < (best, inf if found is None else found):
                            best, found = t, index
                        break
        if best <= after:
            break
    return None if found is None else (found, best if best * length > near else 0.0)
