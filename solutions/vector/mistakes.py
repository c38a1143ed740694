"""How the count in arrays goes wrong, written out circle by circle: what an array does to all, a loop does to each."""

from math import hypot, nan, sqrt


def counted(cx, cy, r, A, B):
    "right"
    (ax, ay), (bx, by) = A, B
    dx, dy = bx - ax, by - ay
    length = hypot(dx, dy)
    # + swapped-coordinates: cx, cy = cy, cx
    # + diameter-for-radius: r = [2 * each for each in r]
    # @ the radius r[i]
    # + in-place: cx, cy = [x - ax for x in cx], [y - ay for y in cy]
    # @ do not write into what you still need
    # : The differences are written into cx and cy themselves, and then they are taken once more.
    # + one-size@every: every = max([0.0, *r, *(abs(p - x) for p in (ax, bx) for x in cx), *(abs(p - y) for p in (ay, by) for y in cy)])
    answer = []
    for x, y, radius in zip(cx, cy, r):
        fx, fy = ax - x, ay - y
        # ? forgotten-centre: fx, fy = ax, ay
        # + zero-radius: if radius == 0:
        # |     answer.append(0)
        # |     continue
        # @ A circle with r = 0
        # + int64-overflow@roots: wrapped = lambda v: (v + 2**63) % 2**64 - 2**63
        # | if all(v == int(v) for v in (x, y, radius, ax, ay, bx, by)):
        # |     k = wrapped(wrapped(int(dx) * int(fy)) - wrapped(int(dy) * int(fx)))
        # |     delta = wrapped(wrapped(int(radius) ** 2 * int(dx * dx + dy * dy)) - wrapped(k * k))
        # |     answer.append(1 + (delta > 0) - (delta < 0))
        # |     continue
        # : The arrays are made whole numbers of 64 bits, and r²·a − k² wraps around.
        d = abs(dx * fy - dy * fx) / length
        # ? global-frame: d = abs(dx / length * ay - dy / length * ax - (dx / length * y - dy / length * x))
        # ? not-divided: d = abs(dx * fy - dy * fx)
        # ? forgotten-abs: d = (dx * fy - dy * fx) / length
        # + radius-not-squared: d = d * d
        size = max(radius, abs(fx), abs(fy), abs(bx - x), abs(by - y))
        # ? radius-epsilon: size = radius
        # ? one-size@every: size = every
        # ? coordinate-epsilon: size = max(radius, abs(x), abs(y), abs(ax), abs(ay), abs(bx), abs(by))
        near = 1e-10 * size
        # ? absolute-epsilon: near = {1e-10..1e-6/4}
        # ? loose-epsilon: near = {1e-4..1e-2/2} * size
        # ? equality-tangency: near = 0.0
        # : For example, the distance is compared with the radius by ==. After a division and a root it is
        # : hardly ever the same.
        # + segment-for-line: t = -(fx * dx + fy * dy) / length**2
        # | if not 0 <= t <= 1: d = min(hypot(fx, fy), hypot(bx - x, by - y))
        # @ The line has no ends
        # : The distance is that of the segment from A to B. The line has no ends.
        hits = 0 if d > radius + near else 2 if d < radius - near else 1
        # ? touch-is-two: hits = 0 if d > radius + near else 2
        # ? touch-is-none: hits = 2 if d < radius - near else 0
        # ? zero-or-two: hits = 0 if d > radius else 2
        # : There are two answers only, by d > r. A touch is 1.
        # ? boolean-array: hits = d <= radius + near
        # @ An array of booleans is not an answer
        # ? boolean-array: hits = int(d <= radius + near)
        # : The comparison's truths are returned, 0 or 1, where a circle that is cut has two points.
        # ? nan-compare: hits = 0 if d > radius else (2 if 2 * sqrt(radius * radius - d * d) > 0 else 1)
        # : A touch is where the half-chord is 0, and rounding leaves it a little more, or nan.
        answer.append(hits)
    return answer
