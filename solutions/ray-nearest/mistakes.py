"""How the ray's first point goes wrong: right ways through it, and mistakes beside the lines that they spoil."""

from math import copysign, floor, hypot, nan, sqrt


def wrap(x, bits):
    # a whole number as an integer of so many bits holds it; a float stays
    return x if isinstance(x, float) else (x + (1 << bits - 1)) % (1 << bits) - (1 << bits - 1)


def quadratic(cx, cy, r, O, D):
    "right"
    # + zero-radius: 1 / r
    # : All lengths are divided by the radius, to make it 1: for r = 0 that is a division by zero. Divide by the
    # : size, or by nothing.
    fx, fy = O[0] - cx, O[1] - cy
    # ? forgotten-centre: fx, fy = O
    # ? reversed-vector: fx, fy = cx - O[0], cy - O[1]
    dx, dy = D
    # ? target-for-direction: dx, dy = D[0] - O[0], D[1] - O[1]
    size = max(r, abs(fx), abs(fy))
    # = size = max(r, hypot(fx, fy))
    # ? coordinate-epsilon: size = max(r, abs(cx), abs(cy), abs(O[0]), abs(O[1]))
    # ? coordinate-epsilon: size = 1 + max(r, abs(cx), abs(cy), abs(O[0]), abs(O[1]))
    # : The threshold is a fraction of 1 plus the coordinates, "to be safe": for a small figure, or one far
    # : away from the plane's origin, that is too wide. Measure the size from the centre, and add nothing
    # : to it.
    near = 1e-10 * size
    # = near = 1e-9 * size
    # ? loose-epsilon: near = 1e-6 * size
    touch = near
    # ? loose-epsilon: touch = 1e-4 * r
    slack = near
    # ? loose-origin: slack = {1e-4..1e-2/2} * size
    # ? parameter-epsilon: slack = {1e-13..1e-7/6} * hypot(dx, dy)
    # + zero-radius: if r == 0: return hypot(fx, fy) / hypot(dx, dy)
    # : For a radius of 0 the way to the centre is returned, wherever the ray looks. The ray meets the point
    # : C only if it passes through it.
    a = dx * dx + dy * dy
    if a == 0:
        return None
        # ? no-degenerate: return 0
        # : D = (0, 0) is answered with 0, as if the ray were met where it begins. There is no ray then:
        # : return None.
        # ? no-degenerate: return nan
        # : The length of D = (0, 0) is divided by all the same, and nan comes out. There is no ray then:
        # : return None before dividing.
        # ? sentinel-miss@s1: return -1
        # ? null-on-circle: return 0 if abs(hypot(fx, fy) - r) <= near else None
        # @ there is no ray
    # ? short-is-null: if a < {1e-12..1e-6/6}: return None
    # ? absolute-epsilon@all3: if a < 1e-7: return None
    length = sqrt(a)
    b = fx * dx + fy * dy
    c = fx * fx + fy * fy - r * r
    # ? wrong-sign: c = fx * fx + fy * fy + r * r
    # ? wrong-sign@w: c = fx * fx + fy * fy + r * r
    # ? global-frame@d: c = O[0] ** 2 + O[1] ** 2 + cx * cx + cy * cy - 2 * (O[0] * cx + O[1] * cy) - r * r
    # ? radius-not-squared@k: c = fx * fx + fy * fy - r
    # : The half-chord is √(r − d²), with the radius as it is. Square the radius.
    k = dx * fy - dy * fx
    disc = r * r * a - k * k
    # ? wrong-sign@w: disc = b * b - a * c
    # ? cancellation@c0: disc = b * b - a * c
    # ? global-frame@d: disc = b * b - a * c
    # ? radius-not-squared@k: disc = b * b - a * c
    # ? direction-not-normalised@b: disc = b * b - c
    # ? cancellation@c4: disc = b * b - a * c
    # : The discriminant (f·D)² - a·c subtracts two numbers that are nearly equal when the circle is small
    # : and far away. Use r²a - k² with k = D × f: the same number, without the cancellation.
    # ? equality-tangency@p2: disc = (b / a) ** 2 - c / a
    # ? absolute-epsilon@all3: disc = b * b - a * c
    # ? overflow-64: disc = wrap(r * r * a, 64) - wrap(k * k, 64)
    # ? overflow-32: disc = wrap(r * r, 32) * wrap(a, 32) - wrap(k, 32) ** 2
    # ? overflow-64@where: disc = wrap(r * r * a - k * k, 64)
    # ? overflow-32@roots: disc = wrap(r * r * a - k * k, 32)
    d = abs(k) / length
    # ? forgotten-abs: d = k / length
    # ? forgotten-abs: d = -k / length
    gap = d - r
    where = 1 if gap > touch else 0 if gap >= -touch else -1
    # ? direction-not-normalised@b: where = 1 if disc < 0 else 0 if disc == 0 else -1
    # ? radius-not-squared@k: where = 1 if disc < 0 else 0 if disc == 0 else -1
    # ? equality-tangency: where = 1 if gap > 0 else 0 if gap == 0 else -1
    # : For example, a tangency is where the distance == r, which floats almost never are. Call it a
    # : tangency when the two differ by less than 1e-10 of the size.
    # ? equality-tangency@p2: where = 1 if disc < 0 else 0 if disc == 0 else -1
    # ? wrong-sign@w: where = 1 if disc < 0 else 0 if disc == 0 else -1
    # ? cancellation@c0: where = 1 if disc < -near * size * a else 0 if disc <= near * size * a else -1
    # ? global-frame@d: where = 1 if disc < -1e-12 * (b * b + abs(a * c)) else 0 if disc <= 1e-12 * (b * b + abs(a * c)) else -1
    # ? absolute-epsilon@all3: where = 1 if disc < -1e-7 else -1
    # ? absolute-epsilon: where = 1 if disc < -1e-10 else 0 if disc <= 1e-10 else -1
    # ? sqrt-of-negative@a: where = 0 if abs(gap) <= touch else -1
    # : The absolute value is taken under the root, "to be safe", so that a line that misses the circle
    # : meets it as well. A negative number there means that there is no common point.
    # ? sqrt-of-negative@b: where = 0 if abs(gap) <= touch else -1
    # : Nothing keeps a line that misses the circle from the square root, which raises ValueError. Compare
    # : the distance with the radius first and return None for a miss.
    # ? cancellation@c4: where = 1 if disc / a < -near * (2 * r + near) else 0 if disc / a <= near * (2 * r - near) else -1
    # ? tangent-missed: where = -1 if disc > 0 else 1
    # ? overflow-64@where: where = 1 if disc / a < -near * (2 * r + near) else 0 if disc / a <= near * (2 * r + near) else -1
    # ? overflow-32@roots: where = 1 if disc / a < -near * (2 * r + near) else 0 if disc / a <= near * (2 * r + near) else -1
    if where == 1:
        return None
        # ? sentinel-miss@s1: return -1
        # ? sentinel-miss: return -1
        # : A line that passes the circle is reported as −1, although a circle behind the origin is None.
        # : Return None for both: −1 is a number like any other.
    if where == 0:
        ts = [-b / a]
    else:
        root = sqrt(abs(disc))
        # ? sqrt-of-negative@a: root = sqrt(abs(disc))
        # ? sqrt-of-negative@b: root = sqrt(disc)
        # = root = sqrt(max(0.0, disc))
        # = root = sqrt(disc)
        # = root = disc ** 0.5
        # ? radius-not-squared: root = sqrt(r * a - k * k)
        # : The half-chord is √|r − d²|, with the radius as it is, and no complaint where that is negative.
        # : Square the radius.
        q = -b - copysign(root, b)
        # ? sign-of-zero: q = -b - ((b > 0) - (b < 0)) * root
        # : Where f·D is 0 the sign of the stable formula is 0, and the root that is found from the other
        # : one is all there is. Take the sign of 0 as +1 (or use copysign).
        ts = sorted([q / a, c / q])
        # = ts = [(-b - root) / a, (-b + root) / a]
        # ? cancellation@c0: ts = [(-b - root) / a, (-b + root) / a]
        # ? overflow-32@roots: ts = [(-b - root) / a, (-b + root) / a]
        # ? floor-division: ts = [(-b - root) // a, (-b + root) // a]
        # ? sqrt-of-negative@a: ts = [(-b - root) / a, (-b + root) / a]
        # ? no-snap@n: ts = [(-b - root) / a, (-b + root) / a]
        # : For example, tangencies have their epsilon, but t >= 0 is taken to the letter, and −m ± h is
        # : less exact still. Let the origin have the same slack, as a length.
        # ? direction-not-normalised@b: ts = [-b - root, -b + root]
        # ? direction-not-normalised: ts = [-b / a - root / length, -b / a + root / length]
        # : t is found by (m ± h), with the half-chord as a length and the foot as a parameter. Divide both
        # : by |D|.
        # ? global-frame: ts = [((O[0] + t * dx) - O[0]) / dx if dx else ((O[1] + t * dy) - O[1]) / dy for t in sorted([q / a, c / q])]
        # : The point of contact is computed in the plane's own coordinates, and t is found from it. Far
        # : from the origin a coordinate has few digits left for it. Compute t from the differences.
        # ? absolute-epsilon@all3: ts = [(-b - root) / a, (-b + root) / a]
        # ? radius-not-squared@k: ts = [(-b - root) / a, (-b + root) / a]
        # ? foot-for-root: ts = [-b / a]
    first = None
    for t in ts:
        if abs(t) * length <= slack:
            first = 0.0
            break
        # ? origin-on-circle: if abs(t) * length <= slack: return None
        # @ With O on the circle it is 0
        # : With the origin on the circle None is returned. t = 0 is allowed: 0 is the answer there.
        # ? origin-on-circle: if t * length <= 1e-6: continue
        # ? no-snap: if t == 0: return 0.0
        # ? no-snap@n: if t >= 0: return t
        # ? absolute-epsilon@all3: if t >= -1e-7: return max(t, 0.0)
        if t > 0:
            first = t
            break
        # ? entry-behind: return t
        # @ What lies behind O
        # : The least of the roots is returned without asking whether it is negative. Skip a root behind the
        # : origin and look at the other one.
    # ? entry-behind: first = ts[0] if ts[-1] >= 0 else None
    # : A negative entry is returned unless both points are behind the origin. Skip a root behind the origin
    # : and look at the other one.
    # ? far-root: first = 0.0 if abs(ts[-1]) * length <= slack else ts[-1] if ts[-1] > 0 else None
    # @ the least t ≥ 0
    # : Where the ray leaves the circle is answered. From outside the other root comes first.
    # ? far-root: first = ts[-1]
    # ? inside-is-miss: first = 0.0 if abs(ts[0]) * length <= slack else ts[0] if ts[0] > 0 else None
    # @ From inside
    # ? centre-behind: first = None if b > 0 and abs(ts[0]) * length > slack else next((max(t, 0.0) for t in ts if t * length >= -slack), None)
    # ? absolute-value: first = min(abs(t) for t in ts)
    # : The absolute value of the foot and the half-chord's difference is returned, so that a circle behind
    # : the origin is met as well. A negative t is behind the origin and does not count.
    # ? absolute-value: first = abs(ts[0])
    # ? least-magnitude: first = min(ts, key=abs)
    # ? least-magnitude: first = (lambda t: 0.0 if abs(t) * length <= slack else t if t > 0 else None)(min(ts, key=abs))
    # ? both-roots: return [t for t in ts if t * length >= -slack]
    # ? disc-for-circle: first = 0.0 if hypot(fx, fy) <= r + slack else next((max(t, 0.0) for t in ts if t * length >= -slack), None)
    # @ not the disc
    # ? segment-for-ray: first = next((max(t, 0.0) for t in ts if t * length >= -slack and t <= 1), None)
    # @ goes on for ever
    # ? foot-for-root: first = max(0.0, -b / a)
    # : t of the point closest to the centre is returned, or 0 if that is behind. Step back from the foot by
    # : the half-chord.
    if first is None:
        return None
        # ? sentinel-miss@s1: return -1
    return first
    # ? distance-for-parameter: return first * length
    # @ not a distance
    # : The direction is normalised, and what is returned is a distance, not t. Divide by |D|.
    # ? distance-for-parameter: return first * a
    # ? point-for-parameter: return (O[0] + first * dx, O[1] + first * dy)
    # : The point is returned, as a list, instead of t. Return the parameter.
    # ? point-for-parameter: return O[0] + first * dx
    # : The x of the point is returned instead of t. Return the parameter.
    # ? floor-division: return (first * length) // length
    # : For example, the distance is divided by |D| with //, and t is a whole number. Divide with /.


def slope(cx, cy, r, O, D):
    "slope-intercept"
    fx, fy = O[0] - cx, O[1] - cy
    dx, dy = D
    near = 1e-10 * max(r, abs(fx), abs(fy))
    if dx == 0 and dy == 0:
        return None
    # + slope-intercept: if dx == 0: return None
    # : A vertical ray, which has no slope, is answered with None. Write it as O + t·D, which knows no special
    # : direction.
    m = dy / dx
    # = m = dy / dx if dx else 0.0
    # = m = dy / (dx or 1e-9)
    # = m = dy / (dx or 1e-12)
    n = fy - m * fx
    a, b, c = 1 + m * m, m * n, n * n - r * r
    disc = b * b - a * c
    if disc < -near * max(r, abs(fx), abs(fy)) * a:
        return None
    # = if disc < -1e-9: return None
    # = if disc < 0: return None
    s = sqrt(abs(disc))
    best = None
    for x in ((-b - s) / a, (-b + s) / a):
        t = (x - fx) / dx
        # = t = (x - fx) / dx if dx else (m * x + n - fy) / dy
        # = t = (x - fx) / (dx or 1e-9)
        if t * hypot(dx, dy) >= -near and (best is None or t < best):
            best = max(t, 0.0)
    return best
