"""How the normal goes wrong: right ways to it, and mistakes beside the lines that they spoil."""

from fractions import Fraction
from math import copysign, hypot, sqrt


def from_the_centre(cx, cy, r, O, D):
    "right"
    # + zero-radius: if r == 0: return (0.0, 0.0)
    dx, dy = D
    # ? always-upwards: dx, dy = (D[0], D[1]) if D[0] else (0, abs(D[1]))
    # ? target-for-direction: dx, dy = D[0] - O[0], D[1] - O[1]
    if r == 0:
        return None
    # ? zero-radius: pass
    # : A radius of 0 goes through the general way, which divides by it. Return None before that.
    length = hypot(dx, dy)
    # = length = sqrt(dx * dx + dy * dy)
    if length == 0:
        return None
        # ? no-degenerate: return (0.0, 0.0)
        # @ D = (0, 0)
        # : D = (0, 0) is answered with a vector of length 0. There is no ray, and so no normal: return None.
    # ? no-degenerate: pass
    # : D = (0, 0) is not asked for, and the length of D is divided by. There is no ray then: return None first.
    # ? short-is-null: if length < 1e-9: return None
    # ? short-is-null: if length * length < 1e-9: return None
    ux, uy = dx / length, dy / length
    # ? needs-unit-direction: ux, uy = dx, dy
    # @ may have any length
    fx, fy = O[0] - cx, O[1] - cy
    # ? forgotten-centre: fx, fy = O
    # @ centre C
    # ? swapped-coordinates: fx, fy = O[0] - cy, O[1] - cx
    # : The centre is taken as (cy, cx). Its x belongs to the x of O.
    reach = max(r, abs(fx), abs(fy))
    # = reach = max(r, hypot(fx, fy))
    # ? coordinate-epsilon: reach = max(r, abs(cx), abs(cy), abs(O[0]), abs(O[1]))
    # ? coordinate-epsilon: reach = max(1, r, abs(fx), abs(fy))
    # : The threshold does not shrink with the figure: a small circle is all epsilon. Measure the
    # : size from the centre, and add nothing to it.
    near = 1e-10 * reach
    # = near = 1e-9 * reach
    # ? absolute-epsilon: near = 1e-9
    # ? loose-epsilon: near = 1e-6 * reach
    touch = slack = near
    # ? absolute-epsilon: touch, slack = 1e-9, near
    # ? loose-epsilon: touch, slack = 1e-6 * reach, near
    # ? loose-origin: touch, slack = near, {1e-4..1e-2/2} * reach
    # ? no-snap: touch, slack = near, 0
    # : Only t ≥ 0 counts, to the letter: with O on the circle, rounding decides whether the ray enters there.
    # : Let a point that is nearly at O count as there: 1e-10 of the size, as a length.
    distance = abs(dx * fy - dy * fx) / length
    # ? needs-unit-direction: distance = abs(dx * fy - dy * fx)
    # : The distance of the line is a cross product that nobody divided by |D|. Divide by it, or make D a unit.
    # ? global-frame: distance = abs((ux * O[1] - uy * O[0]) - (ux * cy - uy * cx))
    # : The distance of the line is the difference of its own offset from the plane's origin and that of the
    # : centre. Far from the origin both are huge and nothing is left of the figure. Subtract C from O first.
    gap = distance - r
    # ? equality: gap = 0 if distance == r else copysign(2 * touch, gap)
    # =: gap = (lambda k, a: 0 if k * k == Fraction(r) ** 2 * a else copysign(2 * touch, k * k - Fraction(r) ** 2 * a))(Fraction(dx) * Fraction(fy) - Fraction(dy) * Fraction(fx), Fraction(dx) ** 2 + Fraction(dy) ** 2)
    if gap > touch:
        return None
        # ? sentinel-miss: return (0.0, 0.0)
        # @ meets nothing
        # : A miss is answered with a vector of length 0. Return None: the contract asks for it.
    # ? sqrt-of-negative@plain: pass
    # ? sqrt-of-negative@abs: pass
    # : "To be safe" the root is taken of the absolute value, and a ray that misses gets a normal. A miss is None.
    # ? foot-for-miss: pass
    to_foot = -(fx * ux + fy * uy)
    # + centre-behind: if to_foot < -slack: return None
    # ? global-frame: to_foot = (cx * ux + cy * uy) - (O[0] * ux + O[1] * uy)
    # : The way to the foot is the difference of two products of coordinates, which far from the origin are huge.
    # : Subtract C from O first.
    # ? wrong-direction: to_foot = fx * ux + fy * uy
    half = sqrt((r - distance) * (r + distance)) if gap < -touch else 0.0
    # = half = sqrt(r * r - distance * distance) if gap < -touch else 0.0
    # ? radius-not-squared: half = sqrt(abs(r - distance * distance)) if gap < -touch else 0.0
    # ? foot-for-hit: half = 0.0
    # ? touch-cut: half = sqrt((r - distance) * (r + distance))
    # : There is no case for a touch: half the chord is the root of a rounding, or of a negative number. Take 0 for
    # : it there.
    # ? sqrt-of-negative@plain: half = sqrt(r * r - distance * distance) if abs(gap) > touch else 0.0
    # ? sqrt-of-negative@abs: half = sqrt(abs(r * r - distance * distance)) if abs(gap) > touch else 0.0
    # ? touch-cut: half = sqrt((r - distance) * (r + distance)) if distance < r else 0.0
    # : A touch that rounding moved inside is cut all the same, and the normal turns by 1e-8 or more. Within the
    # : tolerance it is a touch: take 0 for half the chord.
    first, last = to_foot - half, to_foot + half
    # ? touch-missed: first, last = (to_foot - half, to_foot + half) if half else (-reach - length, -reach - length)
    # : A touch counts as a miss. It has a normal: the one at the foot.
    way, side = first, 1
    # ? far-root: way, side = last, -1
    # : The exit is taken although the ray enters first. Take the nearer point that is not behind O.
    # ? far-root: way, side = last, 1
    # : The second point is taken although the first one is ahead as well. Take the nearer one.
    if first < -slack:
        way, side = last, -1
        # ? inside-is-miss: return None
        # @ From inside
        # ? not-flipped: way, side = last, 1
        # @ It faces the ray
        # ? entry-behind: way, side = max(first, -slack), -1
        # : From inside the entry behind O is used for the exit. Go on to the second point.
    # ? entry-behind@one: if last < -slack: return None
    # ? origin-on-skipped: if first <= slack: way, side = last, -1
    # : With O on the circle the entry there is skipped, and the answer is the other end of the chord. A point at
    # : t = 0 counts.
    # ? on-always-outward: if first < -slack: way, side = last, 1 if abs(hypot(fx, fy) - r) <= near else -1
    if way < -slack:
        return None
    # ? exit-for-behind: pass
    # + segment-for-ray: if way > length + slack: return None
    # ? exit-for-behind: way = abs(way)
    # : The absolute value of the way to the point is taken, and what is behind O is met as well. Leave the sign: a
    # : negative one is behind.
    # ? entry-behind@one: pass
    # ? on-is-none: if way <= slack: return None
    # : With O on the circle None is returned where the ray looks out, as if it had left already. It leaves there:
    # : t = 0 counts.
    nx, ny = (fx + way * ux) / r, (fy + way * uy) / r
    # = nx, ny = (fx + way * ux) / hypot(fx + way * ux, fy + way * uy), (fy + way * uy) / hypot(fx + way * ux, fy + way * uy)
    # ? not-divided-by-r: nx, ny = fx + way * ux, fy + way * uy
    # ? divided-by-square: nx, ny = (fx + way * ux) / (r * r), (fy + way * uy) / (r * r)
    # ? normalised-twice-position: nx, ny = (lambda x, y: (x / hypot(x, y), y / hypot(x, y)) if (x, y) != (0, 0) else (x, y))(O[0] + way * ux, O[1] + way * uy)
    # ? tangent-vector: nx, ny = -(fy + way * uy) / r, (fx + way * ux) / r
    # ? tangent-vector: nx, ny = (fy + way * uy) / r, -(fx + way * ux) / r
    # ? direction-returned: nx, ny = ux, uy
    # ? mirrored-components: nx, ny = (fy + way * uy) / r, (fx + way * ux) / r
    # ? point-returned: nx, ny = O[0] + way * ux, O[1] + way * uy
    # + reflected-instead: nx, ny = (lambda s: (side * (ux - 2 * s * nx), side * (uy - 2 * s * ny)))(ux * nx + uy * ny)
    # + reflected-instead: nx, ny = (lambda s: (side * (dx - 2 * s * nx), side * (dy - 2 * s * ny)))(dx * nx + dy * ny)
    return side * nx, side * ny
    # ? few-decimals: return round(side * nx, 3), round(side * ny, 3)
    # ? inward-always: return -nx, -ny
    # ? away-from-the-ray: return -side * nx, -side * ny


def quadratic(cx, cy, r, O, D):
    "right"
    dx, dy = D
    fx, fy = O[0] - cx, O[1] - cy
    # ? reversed-vector: fx, fy = cx - O[0], cy - O[1]
    a = dx * dx + dy * dy
    if a == 0 or r == 0:
        return None
    # ? short-is-null: if a < {1e-12..1e-6/6} or r == 0: return None
    b, c = fx * dx + fy * dy, fx * fx + fy * fy - r * r
    # ? global-frame: b, c = fx * dx + fy * dy, O[0] ** 2 + O[1] ** 2 + cx * cx + cy * cy - 2 * (O[0] * cx + O[1] * cy) - r * r
    # : c is expanded into |O|² − 2·O·C + |C|² − r², and far from the origin nothing is left of it. Subtract C from
    # : O first.
    reach = max(r, abs(fx), abs(fy))
    near = 1e-10 * reach
    size = sqrt(a)
    gap = abs(dx * fy - dy * fx) / size - r
    disc = b * b - a * c
    # = disc = r * r * a - (dx * fy - dy * fx) ** 2
    # ? needs-unit-direction: disc = b * b - c
    # : The formula for |D| = 1 is used with a D of any length: b² − c lacks its a. Use b² − a·c, or make D a unit.
    where = 1 if gap > near else 0 if gap >= -near else -1
    # ? equality: where = 1 if disc < 0 else 0 if disc == 0 else -1
    # : For example, a touch is where the discriminant == 0, which of rounded numbers hardly any is. Compare
    # : lengths, d with r, within 1e-10 of the size.
    # ? absolute-epsilon: where = 1 if disc < -1e-9 else 0 if disc <= 1e-9 else -1
    if where > 0:
        return None
    root = sqrt(max(0.0, disc)) if where else 0.0
    t = (-b - root) / a
    # ? far-root: t = (-b + root) / a
    # : Where the ray leaves the circle is answered. From outside the other root comes first.
    if t * size < -near:
        t = (-b + root) / a
        # ? needs-unit-direction: t = -b + root
        # : The second root is not divided by a = D·D. Divide by it, or make D a unit.
    if t * size < -near:
        return None
    nx, ny = (fx + t * dx) / r, (fy + t * dy) / r
    # ? direction-not-scaled: nx, ny = (fx + t * dx / size) / r, (fy + t * dy / size) / r
    if where and dx * nx + dy * ny > 0:
        nx, ny = -nx, -ny
    # ? touch-flipped: if dx * nx + dy * ny > 0: nx, ny = -nx, -ny
    return nx, ny


def textbook(cx, cy, r, O, D):
    "absolute-epsilon"
    fx, fy = O[0] - cx, O[1] - cy
    a = D[0] * D[0] + D[1] * D[1]
    if a < 1e-9 or r < 1e-9:
        return None
    # = if a == 0 or r == 0: return None
    b, c = 2 * (fx * D[0] + fy * D[1]), fx * fx + fy * fy - r * r
    disc = b * b - 4 * a * c
    if disc < -1e-9:
        return None
    # = if disc < -1e-12: return None
    # = if disc < 0: return None
    root = sqrt(max(0.0, disc))
    # = root = sqrt(disc) if disc > 1e-9 else 0.0
    # = root = sqrt(disc) if disc > 1e-12 else 0.0
    for t in ((-b - root) / (2 * a), (-b + root) / (2 * a)):
        if t >= -1e-9:
            nx, ny = (O[0] + t * D[0] - cx) / r, (O[1] + t * D[1] - cy) / r
            # = nx, ny = (fx + t * D[0]) / r, (fy + t * D[1]) / r
            if D[0] * nx + D[1] * ny > 1e-9:
                return -nx, -ny
            # = if D[0] * nx + D[1] * ny > 0: return -nx, -ny
            return nx, ny
    return None


def slope(cx, cy, r, O, D):
    "slope-intercept"
    if r == 0 or D == (0, 0):
        return None
    fx, fy = O[0] - cx, O[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy))
    # + slope-intercept: if D[0] == 0: return None
    # : A vertical ray, which has no slope, is answered with None. Write it as O + t·D, which knows no special
    # : direction.
    m = D[1] / D[0]
    # = m = D[1] / (D[0] or 1e-9)
    n = fy - m * fx
    d = abs(n) / sqrt(1 + m * m)
    if d > r + near:
        return None
    root = sqrt(max(0.0, r * r * (1 + m * m) - n * n)) if d < r - near else 0.0
    xs = sorted(((-m * n - root) / (1 + m * m), (-m * n + root) / (1 + m * m)), reverse=D[0] < 0)
    for x, side in zip(xs, (1, -1)):
        if (x - fx) * D[0] >= -near * abs(D[0]):
            side = side if root else 1
            return side * x / r, side * (m * x + n) / r
    return None
