"""How the hits along a ray go wrong: right ways to them, and mistakes beside the lines that they spoil."""

from array import array
from math import hypot, sqrt


def single(x):
    return array("f", [x])[0]


def feet(circles, O, D):
    "right"
    # + diameter-for-radius: circles = [(x, y, r / 2) for x, y, r in circles]
    # @ `circles` is a list of 1 to 64 circles `(x, y, r)`
    # + diameter-for-radius: circles = [(x, y, 2 * r) for x, y, r in circles]
    # : The radii are doubled, as if they were given halved. They are the radii: use them as they are.
    # + swapped-coordinates: circles = [(y, x, r) for x, y, r in circles]
    # : The circles' x and y are exchanged, those of O and D are not.
    # + single-precision: circles = [tuple(map(single, circle)) for circle in circles]
    (ox, oy), (dx, dy) = O, D
    # ? target-for-direction: (ox, oy), (dx, dy) = O, (D[0] - O[0], D[1] - O[1])
    size = max(max(r, abs(x - ox), abs(y - oy)) for x, y, r in circles)
    # = size = max(max(r, hypot(x - ox, y - oy)) for x, y, r in circles)
    # ? coordinate-epsilon: size = max(max(r, abs(x), abs(y), abs(ox), abs(oy)) for x, y, r in circles)
    # ? coordinate-epsilon: size = 1 + max(max(r, abs(x - ox), abs(y - oy)) for x, y, r in circles)
    # : The threshold does not shrink with the figure: small circles are all epsilon. Measure the
    # : size by the radii and the centres as seen from O, and add nothing to it.
    near = 1e-10 * size
    # = near = 1e-9 * size
    # ? absolute-epsilon: near = {1e-14..1e-8/6}
    # ? equality: near = 0
    # ? loose-epsilon: near = 1e-4 * size
    slack = near
    # ? no-snap: slack = 0
    # ? loose-origin: slack = {1e-6..1e-3/3} * size
    length = hypot(dx, dy) or 1e-300
    # = length = sqrt(dx * dx + dy * dy) or 1e-300
    ux, uy = dx / length, dy / length
    # ? direction-not-normalised: ux, uy = dx, dy
    hits = []
    # ? sorted-by-distance-of-centre@a: hits, circles, places = [], sorted(circles, key=lambda c: hypot(c[0] - ox, c[1] - oy)), [circles.index(c) for c in sorted(circles, key=lambda c: hypot(c[0] - ox, c[1] - oy))]
    for index, (x, y, r) in enumerate(circles):
        fx, fy = ox - x, oy - y
        # ? forgotten-centre: fx, fy = ox, oy
        # ? reversed-vector: fx, fy = x - ox, y - oy
        # + radius-epsilon: near = 1e-9 * r
        # + zero-radius: if r == 0: continue
        # @ is a point
        # + zero-radius: 1 / r
        # : All lengths are divided by the radius: for r = 0 that is a division by zero. Divide by nothing.
        d = abs(ux * fy - uy * fx)
        # = d = hypot(fx + (-(fx * ux + fy * uy)) * ux, fy + (-(fx * ux + fy * uy)) * uy)
        # ? global-frame: d = abs((ux * oy - uy * ox) - (ux * y - uy * x))
        # ? forgotten-abs: d = ux * fy - uy * fx
        foot = -(fx * ux + fy * uy)
        # ? global-frame: foot = (x * ux + y * uy) - (ox * ux + oy * uy)
        # ? foot-sign: foot = fx * ux + fy * uy
        # + centre-behind: if foot < -near: continue
        if d > r + near:
            continue
        # ? sqrt-of-negative: pass
        if d >= r - near:
            found = [(foot, "touch")]
            # ? touch-tag: found = [(foot, "enter")]
            # ? touch-tag: found = [(foot, "enter"), (foot, "exit")]
            # : A touch is answered as an enter and an exit at one place. It is one hit, a "touch".
            # ? tangent-twice: found = [(foot, "touch"), (foot, "touch")]
            # ? tangent-missed: continue
        else:
            half = sqrt((r - d) * (r + d))
            # = half = sqrt(r * r - d * d)
            # ? radius-not-squared: half = sqrt(abs(r - d * d))
            found = [(foot - half, "enter"), (foot + half, "exit")]
            # ? tags-swapped: found = [(foot - half, "exit"), (foot + half, "enter")]
            # @ where the ray enters the circle
            # ? far-root: found = [(foot + half, "exit")]
            # ? entry-only: found = [(foot - half, "enter")]
            # ? inside-is-miss: found = [(foot - half, "enter"), (foot + half, "exit")] if foot - half >= -near else []
            # @ from inside, the ray hits it on its way out
        found = [(max(s, 0.0), tag) for s, tag in found if s >= -slack]
        # ? behind-included: found = [(s if abs(s) > near else 0.0, tag) for s, tag in found]
        # ? behind-included: found = [(max(s, 0.0), tag) for s, tag in found]
        # : A hit behind the origin is moved to t = 0. Only t >= 0 counts: leave it out.
        # ? behind-included: found = [(abs(s), tag) for s, tag in found]
        # : A hit behind the origin is counted at |t|, in front of it. Only t >= 0 counts: leave it out.
        # ? origin-on-circle: found = [(s, tag) for s, tag in found if s > near]
        # ? exit-first: found = [(max(s, 0.0), "touch" if tag == "touch" else "enter" if n == 0 else "exit") for n, (s, tag) in enumerate([(s, tag) for s, tag in found if s >= -near])]
        # ? segment-for-ray: found = [(max(s, 0.0), tag) for s, tag in found if -near <= s <= length + near]
        # ? parameter-epsilon: found = [(max(s, 0.0), tag) for s, tag in found if s / length >= -{1e-13..1e-7/6}]
        # ? first-only: found = [(max(s, 0.0), tag) for s, tag in found if s >= -near][:1]
        # : Of each circle only the first hit ahead is kept. All of them are asked for: where it is left as well.
        hits += [(s / length, index, tag) for s, tag in found]
        # ? distance-for-parameter: hits += [(s, index, tag) for s, tag in found]
        # @ t is the parameter
        # ? direction-not-normalised: hits += [(s / length / length, index, tag) for s, tag in found]
        # ? index-of-first: hits += [(s / length, circles.index((x, y, r)), tag) for s, tag in found]
        # ? index-from-one: hits += [(s / length, index + 1, tag) for s, tag in found]
        # @ from 0
        # ? rounded-output: hits += [(round(s / length, 6), index, tag) for s, tag in found]
        # ? sorted-by-distance-of-centre@a: hits += [(s / length, places[index], tag) for s, tag in found]
    hits.sort()
    # = hits.sort(key=lambda hit: hit[0])
    # ? per-circle-order: pass
    # ? sorted-by-distance-of-centre@a: pass
    # ? unsorted: hits.sort(key=lambda hit: (hit[2], hit[0]))
    # @ in the order of t
    # ? unsorted: hits.sort(reverse=True)
    # : The hits are sorted backwards. The order is that of t along the ray.
    # ? ties-dropped: hits = sorted({t: (t, index, tag) for t, index, tag in hits}.values())
    # @ Hits at the same place
    # : The hits are kept in a dictionary by t, and of those at one place only one is left. All of them count.
    # ? ties-dropped: hits = [hit for n, hit in enumerate(sorted(hits)) if n == 0 or (hit[0] - sorted(hits)[n - 1][0]) * length > near]
    # ? tags-alternate: hits = [(t, index, tag if tag == "touch" else ("enter", "exit")[n % 2]) for n, (t, index, tag) in enumerate(sorted(hits))]
    # ? first-only: hits = [min(hits)] if hits else []
    return hits


def quadratic(circles, O, D):
    "right"
    e = max(max(r, abs(x - O[0]), abs(y - O[1])) for x, y, r in circles)
    a = D[0] * D[0] + D[1] * D[1]
    step = max(abs(D[0]), abs(D[1]))
    events = []
    for index, (x, y, r) in enumerate(circles):
        fx, fy = O[0] - x, O[1] - y
        b = fx * (D[0] / step) + fy * (D[1] / step)
        k = fy * (D[0] / step) - fx * (D[1] / step)
        n = a / step / step
        gap = abs(k) / sqrt(n) - r
        if gap > 1e-10 * e:
            continue
        root = sqrt((r - abs(k) / sqrt(n)) * (r + abs(k) / sqrt(n)) * n) if gap < -1e-10 * e else 0.0
        roots = [(-b - root) / n, (-b + root) / n] if root else [-b / n]
        # ? tangent-twice: roots = [(-b - root) / n, (-b + root) / n]
        # : The touch is not told apart: two roots that are the same are an enter and an exit. Compare |d − r| with a
        # : part of the size first, and answer one "touch".
        for t in roots:
            if t >= -1e-10 * e:
                slope = fx * D[0] + t * D[0] / step * D[0] + fy * D[1] + t * D[1] / step * D[1]
                tag = "touch" if len(roots) == 1 else "enter" if slope < 0 else "exit"
                # ? touch-tag: tag = "enter" if slope < 0 else "exit"
                events.append((max(t, 0.0) / step, index, tag))
    return sorted(events)


def textbook(circles, O, D):
    """absolute-epsilon

    For example, the discriminant, which is an area times |D|², and t are compared with a fixed number. Measure
    both by the size, as lengths.
    """
    eps = 1e-9
    # = eps = 1e-12
    # = eps = 1e-10
    # = eps = 1e-8
    # = eps = 1e-6
    hits = []
    for index, (x, y, r) in enumerate(circles):
        fx, fy = O[0] - x, O[1] - y
        a, b = D[0] * D[0] + D[1] * D[1], fx * D[0] + fy * D[1]
        disc = b * b - a * (fx * fx + fy * fy - r * r)
        # = disc = r * r * a - (D[0] * fy - D[1] * fx) ** 2
        if disc < -eps:
            continue
        root = sqrt(abs(disc))
        found = [(-b / a, "touch")] if disc < eps else [((-b - root) / a, "enter"), ((-b + root) / a, "exit")]
        hits += [(max(t, 0.0), index, tag) for t, tag in found if t >= -eps]
        # = hits += [(t, index, tag) for t, tag in found if t >= 0]
    return sorted(hits)


def slope(circles, O, D):
    "slope-intercept"
    hits = []
    for index, (x, y, r) in enumerate(circles):
        fx, fy = O[0] - x, O[1] - y
        near = 1e-10 * max(r, abs(fx), abs(fy))
        m = D[1] / D[0]
        # = m = D[1] / D[0] if D[0] else 0.0
        # = m = D[1] / (D[0] or 1e-9)
        n = fy - m * fx
        d = abs(n) / sqrt(1 + m * m)
        if d > r + near:
            continue
        half = sqrt(max(0.0, r * r - d * d)) / sqrt(1 + m * m)
        middle = -m * n / (1 + m * m)
        step = D[0] or 1e-9
        if abs(d - r) <= near:
            found = [((middle - fx) / step, "touch")]
        else:
            ts = sorted([(middle - half - fx) / step, (middle + half - fx) / step])
            found = [(ts[0], "enter"), (ts[1], "exit")]
        hits += [(max(t, 0.0), index, tag) for t, tag in found if t * hypot(*D) >= -near]
    return sorted(hits)
