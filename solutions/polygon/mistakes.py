"""How the crossings of a polygon go wrong: right ways to them, and mistakes beside the lines that they spoil."""

from math import atan2, copysign, hypot, sqrt


def half_open(cx, cy, r, V):
    "right"
    # + diameter-for-radius: r = r / 2
    # + diameter-for-radius: r = 2 * r
    # : The radius is doubled, as if the third argument were half of it. It is the radius: use it as it is.
    # + zero-radius: if r == 0: return []
    # @ With r = 0
    # + zero-radius: if r == 0: return [(0, (cx, cy))]
    # : For a radius of 0 the answer is C on edge 0, wherever C is. It counts only on the boundary, on its own edge.
    # + swapped-coordinates: cx, cy = cy, cx
    # : The centre is taken as (cy, cx). Its x belongs to the x of the corners.
    n = len(V)
    # ? open-polyline: n = len(V) - 1
    # @ the last edge back to V[0]
    size = max(r, *(max(abs(x - cx), abs(y - cy)) for x, y in V))
    # = size = max(r, *(hypot(x - cx, y - cy) for x, y in V))
    # ? coordinate-epsilon: size = max(r, abs(cx), abs(cy), *(max(abs(x), abs(y)) for x, y in V))
    # ? coordinate-epsilon: size = max(1, r, *(max(abs(x - cx), abs(y - cy)) for x, y in V))
    # : The threshold does not shrink with the figure: a small figure is all epsilon. Measure the size from
    # : the centre, and add nothing to it.
    near = 1e-10 * size
    # = near = 1e-9 * size
    # ? absolute-epsilon: near = 1e-9
    # ? absolute-epsilon: near = max(1e-9, 1e-9 * size)
    # : A fixed 1e-9 is the least threshold, and a tiny figure is all epsilon. Measure it by the size alone.
    # ? loose-epsilon: near = {1e-4..1e-2/2} * size
    touch = slack = near
    # ? no-snap: touch, slack = near, 0.0
    # : The ends are taken to the letter, 0 ≤ way < L: rounding decides which edge has a corner, or that both have it, or
    # : none. Let what is nearly at a corner be there: 1e-10 of the size.
    # ? loose-ends: touch, slack = near, {1e-4..1e-2/2} * size
    found = []
    order = range(n)
    # ? closing-first: order = [n - 1, *range(n - 1)]
    for i in order:
        (ax, ay), (bx, by) = V[i], V[(i + 1) % len(V)]
        # = (ax, ay), (bx, by) = V[i], V[i - len(V) + 1]
        dx, dy = bx - ax, by - ay
        # ? point-for-direction: dx, dy = bx, by
        fx, fy = ax - cx, ay - cy
        # ? forgotten-centre: fx, fy = ax, ay
        length = hypot(dx, dy)
        ux, uy = dx / length, dy / length
        d = abs(dx * fy - dy * fx) / length
        # ? global-frame: d = abs((ux * ay - uy * ax) - (ux * cy - uy * cx))
        # : The distance of a line is the difference of its own offset from the plane's origin and that of the centre.
        # : Far from the origin both are huge and nothing is left of the figure. Subtract C first.
        gap = d - r
        # ? equality: gap = 0 if d == r else copysign(2 * touch, gap)
        if gap > touch:
            continue
            # ? none-for-empty: return None
            # : For an edge that misses, None is returned for all of the polygon. Go on with the next edge.
        # ? sqrt-of-negative@plain: pass
        # ? sqrt-of-negative@abs: pass
        # : "To be safe" the root is taken of the absolute value, and lines that miss get points. A miss has none.
        # ? touch-missed: if gap > -touch: continue
        foot = -(fx * ux + fy * uy)
        # ? wrong-direction: foot = fx * ux + fy * uy
        half = sqrt((r - d) * (r + d)) if gap < -touch else 0.0
        # ? sqrt-of-negative@plain: half = sqrt(r * r - d * d) if abs(gap) > touch else 0.0
        # ? sqrt-of-negative@abs: half = sqrt(abs(r * r - d * d)) if abs(gap) > touch else 0.0
        # ? radius-not-squared: half = sqrt(abs(r - d * d)) if gap < -touch else 0.0
        # ? foot-for-hit: half = 0.0
        # ? touch-cut: half = sqrt(max(0.0, (r - d) * (r + d)))
        # : There is no case for a touch: half the chord is the root of some rounding, and one point becomes two.
        # : Compare d with r, and take 0 for it.
        ways = (foot - half, foot + half) if half else (foot,)
        # ? tangent-twice: ways = (foot - half, foot + half)
        # @ that point counts once
        # ? first-root-only: ways = (foot - half,)
        # ? first-root-only: ways = [way for way in (foot - half, foot + half) if -slack <= way < length - slack][:1]
        # ? second-root-only: ways = (foot + half,)
        # ? enters-only: ways = (foot - half,) if half else (foot,)
        # : Only the point where the boundary enters is looked for. It leaves the circle as well.
        # ? reversed-order: ways = (foot + half, foot - half) if half else (foot,)
        # ? corners-decide: ways = ((foot - half, foot + half) if half else (foot,)) if (fx * fx + fy * fy - r * r) * ((bx - cx) ** 2 + (by - cy) ** 2 - r * r) <= 0 or not half else ()
        # ? corners-decide: ways = ((foot - half, foot + half) if half else (foot,)) if min(hypot(fx, fy), hypot(bx - cx, by - cy)) <= r + near else ()
        # : An edge whose corners are both outside is left out. It may cut the circle twice, or touch it.
        # ? line-for-edge: found += [(i, (ax + way * ux, ay + way * uy)) for way in ways]
        # ? clamped: ways = [min(max(way, 0.0), length) for way in ways if way < length - slack]
        for way in ways:
            if -slack <= way < length - slack:
                found.append((i, (ax + way * ux, ay + way * uy)))
                # ? points-only: found.append((ax + way * ux, ay + way * uy))
                # ? edge-from-one: found.append((i + 1, (ax + way * ux, ay + way * uy)))
                # @ Edge i goes from V[i] to the next corner
                # ? point-from-centre: found.append((i, (fx + way * ux, fy + way * uy)))
                # ? mirrored-components: found.append((i, (ay + way * uy, ax + way * ux)))
                # ? parameter-for-point: found.append((i, way / length))
                # ? wrong-edge: found.append(((i if abs(way) > slack else (i - 1) % n), (ax + way * ux, ay + way * uy)))
                # : A corner is given as that of the edge that ends there. It belongs to the edge that starts there.
            # ? no-snap: if -1e-10 <= way / length < 1 - 1e-10: found.append((i, (ax + way * ux, ay + way * uy)))
            # : The slack at a corner is a part of the edge. On a short edge it is less than rounding, which then
            # : decides which edge has a corner. Take a part of the size.
            # ? vertex-twice: if -slack <= way <= length + slack: found.append((i, (ax + way * ux, ay + way * uy)))
            # @ A crossing at a corner counts once
            # : Both edges of a corner on the circle give it. Let each edge have its first corner only.
            # ? vertex-twice: if -slack <= way < length - slack or (i == n - 1 and abs(way - length) <= slack): found.append((i, (ax + way * ux, ay + way * uy)))
            # : V[0] is given by the first edge, and once more by the one that closes the polygon. Leave it to the first.
            # ? vertex-lost: if slack < way < length - slack: found.append((i, (ax + way * ux, ay + way * uy)))
            # : Neither edge of a corner on the circle gives it: both ends are left out. Let each edge have its first one.
            # ? line-for-edge: found.append((i, (ax + way * ux, ay + way * uy)))
            # ? edge-past-the-end: if -slack <= way: found.append((i, (ax + way * ux, ay + way * uy)))
            # ? edge-past-the-end: if way < length - slack: found.append((i, (ax + way * ux, ay + way * uy)))
        # ? disc-for-circle: if hypot(fx, fy) < r - near and not any(-slack <= way < length - slack for way in ways): found.append((i, V[i]))
        # @ The circle is the curve
    return found
    # ? none-for-empty: return found or None
    # ? sorted-by-x: return sorted(found, key=lambda hit: hit[1])
    # @ in order along the boundary
    # ? sorted-by-x: return sorted(found, key=lambda hit: (hit[0], hit[1]))
    # : The crossings of an edge are sorted by x. Which one comes first depends on the way that the edge runs.
    # ? sorted-by-angle: return sorted(found, key=lambda hit: atan2(hit[1][1] - cy, hit[1][0] - cx))
    # ? sorted-by-angle: return sorted(found, key=lambda hit: atan2(hit[1][1] - cy, hit[1][0] - cx) % 6.283185307179586)
    # ? sorted-by-distance: return sorted(found, key=lambda hit: hypot(hit[1][0] - V[0][0], hit[1][1] - V[0][1]))


def quadratic(cx, cy, r, V):
    "right"
    n = len(V)
    e = max(r, *(max(abs(x - cx), abs(y - cy)) for x, y in V))
    near = 1e-10 * e
    found = {}
    edges = range(n)
    for i in edges:
        (ax, ay), (bx, by) = V[i], V[(i + 1) % n]
        dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
        a, b, c = dx * dx + dy * dy, fx * dx + fy * dy, fx * fx + fy * fy - r * r
        size = sqrt(a)
        gap = abs(dx * fy - dy * fx) / size - r
        disc = r * r * a - (dx * fy - dy * fx) ** 2
        # ? global-frame: disc = b * b - a * (ax * ax + ay * ay + cx * cx + cy * cy - 2 * (ax * cx + ay * cy) - r * r)
        # : c is expanded into |A|² − 2·A·C + |C|² − r², and far from the origin nothing is left of it. Subtract C
        # : first.
        # ? unhalved: disc = b * b - 4 * a * c
        where = 1 if gap > near else 0 if gap >= -near else -1
        # ? equality: where = 1 if disc < 0 else 0 if disc == 0 else -1
        # : For example, a touch is where the discriminant == 0, which of rounded numbers hardly any is.
        # : Compare lengths, d with r, within 1e-10 of the size.
        # ? absolute-epsilon: where = 1 if disc < -1e-6 else 0 if disc <= 1e-6 else -1
        # ? unhalved: where = 1 if b * b - 4 * a * c < -near * near else where
        if where > 0:
            continue
        root = sqrt(max(0.0, disc)) if where else 0.0
        ts = ((-b - root) / a, (-b + root) / a) if where else (-b / a,)
        for place, t in enumerate(ts, 1):
            point = (ax + t * dx, ay + t * dy)
            if abs(t) * size <= near:
                found[i, 0] = point
                # ? wrong-edge: found[(i - 1) % n, 3] = point
            elif abs(t - 1) * size <= near:
                found[(i + 1) % n, 0] = point
            elif 0 < t < 1:
                found[i, place] = point
    # ? wrong-edge: found = {((k[0] - 1) % n, 3) if k[1] == 0 else k: point for k, point in found.items()}
    # : A corner is given as that of the edge that ends there. It belongs to the edge that starts there.
    return [(k[0], found[k]) for k in sorted(found)]


def textbook(cx, cy, r, V):
    "absolute-epsilon"
    found = []
    for i in range(len(V)):
        (ax, ay), (bx, by) = V[i], V[(i + 1) % len(V)]
        dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
        a, b, c = dx * dx + dy * dy, 2 * (fx * dx + fy * dy), fx * fx + fy * fy - r * r
        disc = b * b - 4 * a * c
        if disc < -1e-9:
            continue
        # = if disc < -1e-12: continue
        # = if disc < 0: continue
        root = sqrt(max(0.0, disc))
        ts = [-b / (2 * a)] if disc < 1e-9 else [(-b - root) / (2 * a), (-b + root) / (2 * a)]
        # = ts = [-b / (2 * a)] if disc < 1e-12 else [(-b - root) / (2 * a), (-b + root) / (2 * a)]
        # = ts = [-b / (2 * a)] if root < 1e-9 else [(-b - root) / (2 * a), (-b + root) / (2 * a)]
        for t in ts:
            if -1e-9 <= t < 1 - 1e-9:
                found.append((i, (ax + t * dx, ay + t * dy)))
            # = if -1e-12 <= t < 1 - 1e-12: found.append((i, (ax + t * dx, ay + t * dy)))
    return found


def slope(cx, cy, r, V):
    "slope-intercept"
    near = 1e-10 * max(r, *(max(abs(x - cx), abs(y - cy)) for x, y in V))
    found = []
    for i in range(len(V)):
        (ax, ay), (bx, by) = V[i], V[(i + 1) % len(V)]
        # + slope-intercept: if ax == bx: continue
        # : An upright edge, which has no slope, is left out. Write it as A + t·(B − A).
        m = (by - ay) / (bx - ax)
        # = m = (by - ay) / ((bx - ax) or 1e-9)
        q = ay - cy - m * (ax - cx)
        d = abs(q) / sqrt(1 + m * m)
        if d > r + near:
            continue
        root = sqrt(max(0.0, r * r * (1 + m * m) - q * q)) if d < r - near else 0.0
        xs = {(-m * q - root) / (1 + m * m), (-m * q + root) / (1 + m * m)}
        for x in sorted(xs, reverse=bx < ax):
            t = (cx + x - ax) / (bx - ax)
            # = t = (cx + x - ax) / ((bx - ax) or 1e-9)
            if -near <= t * hypot(bx - ax, by - ay) < hypot(bx - ax, by - ay) - near:
                found.append((i, (cx + x, cy + m * x + q)))
    return found
