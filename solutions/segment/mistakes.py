"""How the segment's points goes wrong: right ways through it, and mistakes beside the lines that they spoil."""

from math import atan2, copysign, floor, hypot, sqrt


def wrap(x, bits):
    # a whole number as an integer of so many bits holds it; a float stays
    return x if isinstance(x, float) else (x + (1 << bits - 1)) % (1 << bits) - (1 << bits - 1)


def geometric(cx, cy, r, A, B):
    "right"
    # + reversed-order: A, B = B, A
    # @ in order from A to B
    # : The points come out in the order from B to A. They are wanted from A to B.
    ax, ay = A[0] - cx, A[1] - cy
    # ? forgotten-centre@unused: ax, ay = A
    # : cx and cy are never used: the circle is taken to stand at the origin. Subtract the centre from A and
    # : B first, and add it to the points again.
    bx, by = B[0] - cx, B[1] - cy
    # ? forgotten-centre@unused: bx, by = B
    ox, oy = cx, cy
    # ? forgotten-centre@unused: ox, oy = 0, 0
    # ? forgotten-centre: ox, oy = 0, 0
    size = max(r, abs(ax), abs(ay), abs(bx), abs(by))
    # = size = max(r, hypot(ax, ay), hypot(bx, by))
    # ? coordinate-epsilon: size = max(r, abs(cx), abs(cy), abs(A[0]), abs(A[1]), abs(B[0]), abs(B[1]))
    # ? coordinate-epsilon: size = 1 + max(r, abs(cx), abs(cy), abs(A[0]), abs(A[1]), abs(B[0]), abs(B[1]))
    # : All thresholds are a fraction of 1 plus the coordinates, "to be safe": for a small figure, or one
    # : far away from the origin, that is too wide. Measure the size from the centre, and add nothing to
    # : it.
    near = 1e-10 * size
    # = near = 1e-9 * size
    # ? absolute-epsilon: near = 1e-9
    # ? loose-epsilon: near = 1e-6 * size
    touch = near
    # ? loose-epsilon: touch = 1e-4 * r
    slack = near
    # ? no-snap: slack = 0
    # ? loose-clamp: slack = {1e-3..1e-1/2} * size
    point = near
    # ? degenerate-epsilon-absolute: point = {1e-6..1e-3/3}
    # ? degenerate-loose: point = 1e-4 * size
    # = point = 0
    # = point = 1e-10 * r
    dx, dy = bx - ax, by - ay
    length = hypot(dx, dy)
    # + zero-radius: if r == 0: return []
    # + zero-radius: if r == 0: return None
    # : For a radius of 0 None is returned, as if there were no circle. It is the point C: return it if it
    # : lies on the segment; the general way does so by itself.
    if length == 0:
        return [A] if abs(hypot(ax, ay) - r) <= point else []
        # ? no-degenerate: return []
        # @ the segment is that point
        # : A = B is called no segment, and nothing is returned even if the point lies on the circle. Return
        # : the point if its distance from the centre is the radius.
        # ? no-degenerate: return [A]
        # : A = B is answered with that point, whether it is on the circle or not. Return it only if its
        # : distance from the centre is the radius.
        # ? inside-ends@disc: return [A] if hypot(ax, ay) <= r + point else []
        # @ not the disc
    # + short-is-a-point: if length < 1e-7: return [A] if abs(hypot(ax, ay) - r) <= point else []
    ux, uy = dx / length, dy / length
    # + both-ends-out: if min(hypot(ax, ay), hypot(bx, by)) > r + touch: return []
    side = ux * ay - uy * ax
    # ? swapped-coordinates: side = ux * ax - uy * ay
    d = abs(side)
    # ? equality-tangency@f: d = hypot(ax - (ux * ax + uy * ay) * ux, ay - (ux * ax + uy * ay) * uy)
    # : For example, the foot of the perpendicular is computed, and its distance from the centre compared
    # : with the radius by ==. After so many roundings it is hardly ever the same double. Compare within
    # : 1e-10 of the size.
    # ? cancellation: d = sqrt(max(0.0, (ax * ax + ay * ay) * (bx * bx + by * by) - (ax * bx + ay * by) ** 2)) / length
    # : The distance of the line is the root of |a|²·|b|² − (a·b)², by |D|: two numbers that are nearly
    # : equal when C is near the line. The cross product gives it without a difference of large squares.
    # ? global-frame: d = abs((B[1] - A[1]) * cx - (B[0] - A[0]) * cy + B[0] * A[1] - B[1] * A[0]) / length
    # : The line is p·x + q·y = s in the plane's own coordinates, where s is the difference of two large
    # : products. Far from the origin nothing is left of a small figure. Subtract C first, then multiply.
    # ? unnormalised-distance: d = abs(dx * ay - dy * ax)
    # ? cancellation: d = sqrt(max(0.0, ax * ax + ay * ay - (ux * ax + uy * ay) ** 2))
    # : The distance of the line is the root of |f|² − m², two squares that are nearly equal when A is far
    # : away. The cross product gives it without a difference: |D × f| / |D|.
    # ? global-frame: d = abs(ux * A[1] - uy * A[0] - (ux * cy - uy * cx))
    # ? forgotten-abs: d = side
    # ? forgotten-abs: d = -side
    m = -(ux * ax + uy * ay)
    # ? foot-sign: m = ux * ax + uy * ay
    where = 1 if d > r + touch else 0 if d >= r - touch else -1
    # ? equality-tangency: where = 1 if d > r else 0 if d == r else -1
    # : For example, a tangency is where the distance == r, which floats almost never are. Call it a
    # : tangency when the two differ by less than 1e-10 of the size.
    # ? equality-tangency@f: where = 1 if d > r else 0 if d == r else -1
    # ? absolute-epsilon: where = 1 if d * d > r * r + 1e-13 else 0 if d * d >= r * r - 1e-13 else -1
    # ? tangent-missed: where = 1 if d > r - touch else -1
    # ? tangent-twice: where = 1 if d > r + touch else -1
    # @ not two equal ones
    # ? sqrt-of-negative@a: where = 0 if abs(d - r) <= touch else -1
    # ? sqrt-of-negative@b: where = 0 if abs(d - r) <= touch else -1
    # : Nothing keeps a line that misses the circle from the square root, which raises ValueError. Compare
    # : the line's distance with the radius first.
    if where == 1:
        return []
        # ? none-for-empty: return None
        # : Where the line misses the circle, None is returned. Return an empty list: the answer is always a
        # : list.
        # ? none-for-empty@f: return False
        # : Where there is no common point, False is returned. Return an empty list: the answer is always a
        # : list.
    if where == 0:
        roots = [m]
        # ? tangent-unclamped: return [(ox + ax + m * ux, oy + ay + m * uy)]
    else:
        h = sqrt(abs((r - d) * (r + d)))
        # = h = sqrt((r - d) * (r + d))
        # = h = sqrt(max(0.0, r * r - d * d))
        # = h = sqrt(r * r - d * d)
        # ? sqrt-of-negative@a: h = sqrt(abs(r * r - d * d))
        # ? sqrt-of-negative@b: h = sqrt(r * r - d * d)
        # ? radius-not-squared: h = sqrt(abs(r - d * d))
        # : The half-chord is √|r − d²|, with the radius as it is, and no complaint where that is negative.
        # : Square the radius.
        # ? radius-not-squared: h = sqrt(r - d * d)
        # ? root-forgotten: h = (r - d) * (r + d)
        roots = [m - h, m + h]
        # ? unsorted: roots = [m - h, m + h] if side > 0 else [m + h, m - h]
        # ? first-root-only: roots = [m - h]
        # : Only the first of the two roots is looked at: a segment that begins inside the circle leaves it
        # : without being noticed. Look at both roots, each on its own.
        # ? first-root-only: roots = [m + h]
        # : Only one of two points is returned. Look at both roots, each on its own.
    # + inside-ends: if len(roots) == 2 and roots[0] < -slack and roots[1] > length + slack: return [A, B]
    # + inside-ends@disc: roots = (lambda a, b: [] if a > b + near else [a] if b - a <= near else [a, b])(max(0.0, roots[0]), min(length, roots[-1]))
    kept = [s for s in roots if -slack <= s <= length + slack]
    # ? no-clamp: kept = roots
    # ? no-clamp: kept = [s for s in roots if -slack <= s]
    # : Points beyond B are returned as well, as if the segment were a ray. Keep a root only if it is on the
    # : segment, at both ends.
    # ? clamp-to-ends: kept = [min(max(s, 0.0), length) for s in roots]
    # : The roots are clamped to the segment and both returned, although neither end need be on the circle,
    # : and they may be the same point. Drop a root that is not on the segment.
    # ? clamp-to-ends: kept = [min(max(s, 0.0), length) for s in roots] if roots[-1] >= 0 and roots[0] <= length else []
    # ? open-interval: kept = [s for s in roots if slack < s < length - slack]
    # @ includes both
    # ? open-interval: kept = [s for s in roots if -slack <= s < length - slack]
    # : For example, a root counts if it is at A or after it, but not at B: a half-open interval, as of
    # : range(). The segment is closed, at both ends.
    # ? x-range-only: kept = [s for s in roots if min(ax, bx) - slack <= ax + s * ux <= max(ax, bx) + slack]
    # ? x-range-only: kept = [s for s in roots if min(ay, by) - slack <= ay + s * uy <= max(ay, by) + slack]
    # : Only the y of a point is held against the segment's ends, which says nothing where the segment is
    # : horizontal. Compare t with 0 and 1 (or both coordinates).
    # ? first-root-only: kept = [s for s in roots if -slack <= s <= length + slack][-1:]
    # : Only the last common point is returned. Look at both roots, each on its own.
    # ? floor-division: kept = [float(floor(s / length)) * length for s in roots if 0 <= s // length <= 1]
    # ? floor-division: kept = [(s * 1.0) // 1 for s in roots if -slack <= s <= length + slack]
    points = [(ox + ax + s * ux, oy + ay + s * uy) for s in kept]
    # ? parameter-for-point: points = [s / length for s in kept]
    # ? parameter-for-point: points = kept
    # : The distances from A are returned instead of the points. Put each of them back into the segment: A +
    # : s·u.
    # ? sorted-by-x: points = sorted((ox + ax + s * ux, oy + ay + s * uy) for s in kept)
    # ? sorted-by-x: points = sorted(((ox + ax + s * ux, oy + ay + s * uy) for s in kept), reverse=True)
    # : The points are sorted from right to left. Order them by t, that is by the distance from A.
    # ? unsorted: points = sorted(((ox + ax + s * ux, oy + ay + s * uy) for s in kept), key=lambda p: atan2(p[1] - cy, p[0] - cx))
    # : The points are put in the order of their angles about the centre, which is not that of the segment.
    # : Sort them by t.
    return points
    # ? none-for-empty@f: return points or False


def quadratic(cx, cy, r, A, B):
    "right"
    fx, fy = A[0] - cx, A[1] - cy
    gx, gy = B[0] - cx, B[1] - cy
    size = max(r, abs(fx), abs(fy), abs(gx), abs(gy))
    near = 1e-10 * size
    dx, dy = B[0] - A[0], B[1] - A[1]
    a = dx * dx + dy * dy
    if a == 0:
        return [A] if abs(hypot(fx, fy) - r) <= near else []
        # ? degenerate-epsilon-absolute: return [A] if abs(fx * fx + fy * fy - r * r) <= 1e-7 else []
        # ? degenerate-tight: return [A] if fx * fx + fy * fy - r * r == 0 else []
        # ? equality-tangency@p2: return [A] if fx * fx + fy * fy - r * r == 0 else []
    # ? no-degenerate: pass
    # ? absolute-epsilon@all: if a < 1e-4: return [A] if abs(fx * fx + fy * fy - r * r) <= 1e-4 else []
    b = fx * dx + fy * dy
    c = fx * fx + fy * fy - r * r
    # ? wrong-sign: c = fx * fx + fy * fy + r * r
    # ? wrong-sign@w: c = fx * fx + fy * fy + r * r
    # ? global-frame: c = A[0] ** 2 + A[1] ** 2 + cx * cx + cy * cy - 2 * (A[0] * cx + A[1] * cy) - r * r
    # ? global-frame@rel: c = A[0] ** 2 + A[1] ** 2 + cx * cx + cy * cy - 2 * (A[0] * cx + A[1] * cy) - r * r
    # ? radius-not-squared: c = fx * fx + fy * fy - r
    # ? radius-not-squared@b: c = fx * fx + fy * fy - r
    k = dx * fy - dy * fx
    disc = r * r * a - k * k
    # ? cancellation@u: disc = ((fx * (dx / sqrt(a)) + fy * (dy / sqrt(a))) ** 2 - c) * a
    # : b² − c for a direction of length 1 is |f·u|² − |f|² + r²: two squares that are nearly equal when A
    # : is far away. The cross product gives the distance of the line without a difference.
    # ? global-frame@rel: disc = (dx * A[0] + dy * A[1] - dx * cx - dy * cy) ** 2 - a * c
    # ? radius-not-squared@b: disc = b * b - a * c
    # ? wrong-sign@w: disc = b * b - a * c
    # ? cancellation@c0: disc = b * b - a * c
    # ? equality-tangency@p2: disc = (b / a) ** 2 - c / a
    # ? absolute-epsilon@all: disc = b * b - a * c
    # ? overflow-64: disc = wrap(r * r * a - k * k, 64)
    # ? overflow-32: disc = wrap(r * r, 32) * wrap(a, 32) - wrap(k, 32) ** 2
    # ? overflow-64@where: disc = wrap(r * r * a - k * k, 64)
    # ? overflow-32@roots: disc = wrap(r * r * a - k * k, 32)
    length = sqrt(a)
    gap = abs(k) / length - r
    where = 1 if gap > near else 0 if gap >= -near else -1
    # ? equality-tangency: where = 1 if disc < 0 else 0 if disc == 0 else -1
    # : For example, the discriminant is compared with 0 by ==. Its terms are rounded, and a touch is hardly
    # : ever exactly 0. Compare lengths, within a small part of the size.
    # ? equality-tangency@p2: where = 1 if disc < 0 else 0 if disc == 0 else -1
    # ? wrong-sign@w: where = 1 if disc < 0 else 0 if disc == 0 else -1
    # ? cancellation@c0: where = 1 if disc < -near * size * a else 0 if disc <= near * size * a else -1
    # ? cancellation@u: where = 1 if disc / a < -near * (2 * r + near) else 0 if disc / a <= near * (2 * r - near) else -1
    # ? global-frame@rel: where = 1 if disc < -1e-12 * (b * b + abs(a * c)) else 0 if disc <= 1e-12 * (b * b + abs(a * c)) else -1
    # ? absolute-epsilon@all: where = 1 if disc < -1e-4 else 0 if disc <= 1e-4 else -1
    # ? absolute-epsilon: where = 1 if disc < -1e-13 else 0 if disc <= 1e-13 else -1
    # ? radius-not-squared@b: where = 1 if disc < 0 else 0 if disc == 0 else -1
    # ? overflow-64@where: where = 1 if disc / a < -near * (2 * r + near) else 0 if disc / a <= near * (2 * r + near) else -1
    # ? overflow-32@roots: where = 1 if disc / a < -near * (2 * r + near) else 0 if disc / a <= near * (2 * r + near) else -1
    if where == 1:
        return []
    # ? sqrt-of-negative: pass
    if where == 0:
        ts = [-b / a]
    else:
        root = sqrt(abs(disc))
        # = root = sqrt(disc)
        # = root = sqrt(max(0.0, disc))
        # = root = disc ** 0.5
        q = -(b + copysign(root, b))
        # ? sign-of-zero: q = -(b + ((b > 0) - (b < 0)) * root)
        # : The stable formula takes its sign from b, and the sign of 0 is 0 there. Then both roots are
        # : lost, or divided by 0. Take the sign of 0 as +1 (or use copysign).
        # ? sign-of-zero@g: q = -(b + ((b > 0) - (b < 0)) * root)
        ts = sorted([q / a, c / q])
        # ? sign-of-zero@g: ts = sorted([q / a, c / q if q else q / a])
        # = ts = [(-b - root) / a, (-b + root) / a]
        # ? overflow-32@roots: ts = [(-b - root) / a, (-b + root) / a]
        # ? radius-not-squared@b: ts = [(-b - root) / a, (-b + root) / a]
    slack = near / length
    # ? absolute-epsilon@all: slack = 1e-4
    # ? loose-clamp: slack = 1e-4
    # ? no-snap: slack = 0
    # : For example, the roots are rounded, and 0 <= t <= 1 has no room for that: where an end is on the
    # : circle its t is 1e-17 or -1e-17. Give t the slack of 1e-9 of the size, divided by |D|.
    kept = [t for t in ts if -slack <= t <= 1 + slack]
    # ? no-clamp: kept = [t for t in ts if t <= 1 + slack]
    # ? open-interval: kept = [t for t in ts if slack < t <= 1 + slack]
    # ? first-root-only: kept = [t for t in ts if -slack <= t <= 1 + slack][:1]
    return [(A[0] + t * dx, A[1] + t * dy) for t in kept]
    # ? floor-division: return [(A[0] - b * dx // a + (t + b / a) * dx, A[1] - b * dy // a + (t + b / a) * dy) for t in kept]
    # ? none-for-empty: return [(A[0] + t * dx, A[1] + t * dy) for t in kept] or None


def slope(cx, cy, r, A, B):
    "slope-intercept"
    fx, fy, gx, gy = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    size = max(r, abs(fx), abs(fy), abs(gx), abs(gy))
    near = 1e-10 * size
    if A == B:
        return [A] if abs(hypot(fx, fy) - r) <= near else []
    # + slope-intercept: if A[0] == B[0]: return []
    # : A vertical segment, which has no slope, is answered with []. Work with the direction B − A.
    p, q = (gy - fy, gx - fx)
    m = p / q
    # = m = p / q if q else 0.0
    # = m = p / (q or 1e-9)
    # = m = p / (q or 1e-12)
    n = fy - m * fx
    a, b, c = 1 + m * m, m * n, n * n - r * r
    disc = b * b - a * c
    if disc < -near * size * a:
        return []
    # = if disc < -1e-9 * b * b: return []
    # = if disc < -1e-9: return []
    # = if disc < 0: return []
    s = sqrt(abs(disc))
    xs = [-b / a] if disc <= near * size * a else [(-b - s) / a, (-b + s) / a]
    # = xs = [-b / a] if disc <= 1e-9 else [(-b - s) / a, (-b + s) / a]
    # = xs = [-b / a] if disc <= 1e-9 * b * b else [(-b - s) / a, (-b + s) / a]
    # = xs = [-b / a] if disc == 0 else [(-b - s) / a, (-b + s) / a]
    if gx < fx:
        xs = xs[::-1]
    # = pass
    lo, hi = min(fx, gx) - near, max(fx, gx) + near
    # = lo, hi = min(fx, gx) - 1e-9, max(fx, gx) + 1e-9
    return [(cx + x, cy + m * x + n) for x in xs if lo <= x <= hi]
