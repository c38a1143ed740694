"""How the points of a line on a circle go wrong."""

from fractions import Fraction
from math import atan2, copysign, hypot, sqrt


def shortest(p, c):
    # the difference of what the two doubles are shown as
    return float(Fraction(str(p)) - Fraction(str(c)))


def foot(cx, cy, r, A, B):
    "right"
    # + reversed-order: A, B = B, A
    # @ in order of t
    # : The points come out in the order from B to A. They are wanted from A to B.
    ax, ay = A[0] - cx, A[1] - cy
    # ? shortest-decimal@s: ax, ay = shortest(A[0], cx), shortest(A[1], cy)
    # ? forgotten-centre@unused: ax, ay = A
    bx, by = B[0] - cx, B[1] - cy
    # ? shortest-decimal@s: bx, by = shortest(B[0], cx), shortest(B[1], cy)
    # ? forgotten-centre@unused: bx, by = B
    ox, oy = cx, cy
    # ? forgotten-centre@unused: ox, oy = 0, 0
    # ? forgotten-centre: ox, oy = 0, 0
    # : The points are given as seen from the centre. Add it to them again.
    size = max(r, abs(ax), abs(ay), abs(bx), abs(by))
    # = size = max(r, hypot(ax, ay), hypot(bx, by))
    # ? coordinate-epsilon: size = max(r, abs(cx), abs(cy), abs(A[0]), abs(A[1]), abs(B[0]), abs(B[1]))
    # ? coordinate-epsilon: size = max(1, r, abs(ax), abs(ay), abs(bx), abs(by))
    # : The threshold does not shrink with the figure: a small circle is all epsilon. Measure the
    # : size from the centre, and add nothing to it.
    near = 1e-10 * size
    # = near = 1e-9 * size
    # ? absolute-epsilon: near = 1e-9
    # ? loose-epsilon: near = 1e-4 * size
    dx, dy = B[0] - A[0], B[1] - A[1]
    # ? shortest-decimal@s: dx, dy = shortest(B[0], A[0]), shortest(B[1], A[1])
    # ? point-for-direction: dx, dy = B
    length = hypot(dx, dy)
    # ? unit-forgotten: length = 1 if dx or dy else 0
    # + zero-radius: if r == 0: return []
    # @ With r = 0
    # + zero-radius: if r == 0: return [(cx, cy)]
    # : For a radius of 0 the centre is returned, wherever the line is. It is a common point only if it lies on
    # : the line.
    if length == 0:
        return None
        # ? no-degenerate: return []
        # @ If A and B are equal
    # ? no-degenerate: pass
    # : The direction is divided by its length without asking whether it has one: for A = B that is a
    # : division by zero. Return None before anything else.
    ux, uy = dx / length, dy / length
    side = ux * ay - uy * ax
    # ? swapped-coordinates: side = ux * ax - uy * ay
    # : The cross product is taken with x and y mixed up. It is ux·fy − uy·fx.
    # ? global-frame: side = ux * A[1] - uy * A[0] - (ux * cy - uy * cx)
    # ? global-frame: side = (B[0] * A[1] - A[0] * B[1] + (B[1] - A[1]) * cx - (B[0] - A[0]) * cy) / length
    d = abs(side)
    # ? forgotten-abs: d = side
    # ? cancellation: d = sqrt(max(0.0, ax * ax + ay * ay - (ux * ax + uy * ay) ** 2))
    # : The distance of the line is the root of |f|² − m², two squares that are nearly equal when A is far
    # : away. The cross product gives it without a difference: |D × f| / |D|.
    m = -(ux * ax + uy * ay)
    # ? foot-sign: m = ux * ax + uy * ay
    where = 1 if d > r + near else 0 if d >= r - near else -1
    # + snapped-to-centre: if where == -1 and d <= 1e-6 * size and r > 1e-3 * size: return [(ox - r * ux, oy - r * uy), (ox + r * ux, oy + r * uy)]
    # ? equality: where = 1 if d * d > r * r else 0 if d * d == r * r else -1
    # ? absolute-epsilon: where = 1 if d > r else 0 if r * r - d * d <= 1e-6 else -1
    # : For example, what stands under the root is compared with a fixed number, whatever the size of the
    # : figure. Compare lengths, within a small part of the size.
    # ? tangent-missed: where = 1 if d > r - near else -1
    # ? tangent-twice: where = 1 if d > r + near else -1
    # @ not two equal ones
    # ? sqrt-of-negative@a: where = 0 if abs(d - r) <= near else -1
    # ? sqrt-of-negative@b: where = 0 if abs(d - r) <= near else -1
    # : Nothing keeps a line that misses the circle from the root: the program ends there. Return [] first.
    if where == 1:
        return []
        # ? none-for-empty: return None
        # ? none-for-empty: return False
        # : A miss is answered with False. Return an empty list.
    if where == 0:
        roots = [m]
    else:
        h = sqrt(abs((r - d) * (r + d)))
        # = h = sqrt((r - d) * (r + d))
        # = h = sqrt(max(0.0, r * r - d * d))
        # ? sqrt-of-negative@a: h = sqrt(abs(r * r - d * d))
        # : The absolute value is taken under the root, "to be safe", so that a miss gets points as well.
        # ? sqrt-of-negative@b: h = sqrt(r * r - d * d)
        # ? radius-not-squared: h = sqrt(max(0.0, r - d * d))
        # ? root-forgotten: h = (r - d) * (r + d)
        # ? wrong-sign: h = sqrt(r * r + d * d)
        # ? unit-forgotten: h = sqrt((r - d) * (r + d)) * length
        roots = [m - h, m + h]
        # ? unsorted: roots = [m - h, m + h] if side > 0 else [m + h, m - h]
        # ? first-root-only: roots = [m - h]
        # ? first-root-only: roots = [m + h]
        # ? foot-only: roots = [m]
    # + clamped: roots = [s for s in roots if -near <= s <= length + near]
    # @ goes on for ever
    # + clamped: roots = sorted({min(max(s, 0.0), length) for s in roots})
    # : Points that are not on AB are moved to its ends. The line has no ends.
    points = [(ox + ax + s * ux, oy + ay + s * uy) for s in roots]
    # = points = [(ox - side * uy + (s - m) * ux, oy + side * ux + (s - m) * uy) for s in roots]
    # ? sorted-by-x: points = sorted((ox + ax + s * ux, oy + ay + s * uy) for s in roots)
    # ? sorted-by-x: points = sorted(((ox + ax + s * ux, oy + ay + s * uy) for s in roots), key=lambda p: p[1])
    # : The points are sorted by y. Order them by t, on the way from A to B.
    # ? unsorted: points = sorted(((ox + ax + s * ux, oy + ay + s * uy) for s in roots), key=lambda p: atan2(p[1] - cy, p[0] - cx))
    # : The points are put in the order of their angles about the centre. Order them by t.
    # ? parameter-for-point: points = [s / length for s in roots]
    return points
    # ? set-of-points: return set(points)
    # ? set-of-points: return dict(enumerate(points))
    # : The points come in a dict. Return a list of them.


def quadratic(cx, cy, r, A, B):
    "right"
    fx, fy = A[0] - cx, A[1] - cy
    gx, gy = B[0] - cx, B[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy), abs(gx), abs(gy))
    dx, dy = B[0] - A[0], B[1] - A[1]
    a = dx * dx + dy * dy
    if a == 0:
        return None
    b = fx * dx + fy * dy
    c = fx * fx + fy * fy - r * r
    # ? wrong-sign: c = fx * fx + fy * fy + r * r
    # ? radius-not-squared: c = fx * fx + fy * fy - r
    k = dx * fy - dy * fx
    disc = r * r * a - k * k
    # ? cancellation@e: disc = b * b - a * c
    # ? cancellation@g: disc = b * b - a * c
    gap = abs(k) / sqrt(a) - r
    where = 1 if gap > near else 0 if gap >= -near else -1
    # ? cancellation@e: where = 1 if disc < -near * r * a else 0 if disc <= near * r * a else -1
    # ? cancellation@g: where = 1 if disc / a < -near * (2 * r + near) else 0 if disc / a <= near * (2 * r - near) else -1
    # ? equality: where = 1 if disc < 0 else 0 if disc == 0 else -1
    # ? absolute-epsilon: where = 1 if disc < -{1e-15..1e-6/9} else 0 if disc <= {1e-15..1e-6/9} else -1
    if where == 1:
        return []
    if where == 0:
        ts = [-b / a]
    else:
        root = sqrt(abs(disc))
        q = -(b + copysign(root, b))
        # ? sign-of-zero: q = -(b + ((b > 0) - (b < 0)) * root)
        # ? sign-of-zero@g: q = -(b + ((b > 0) - (b < 0)) * root)
        ts = sorted([q / a, c / q])
        # ? sign-of-zero@g: ts = sorted([q / a, c / q if q else q / a])
        # = ts = [(-b - root) / a, (-b + root) / a]
        # ? unhalved: ts = [(-b - root) / (2 * a), (-b + root) / (2 * a)]
    return [(A[0] + t * dx, A[1] + t * dy) for t in ts]


def slope(cx, cy, r, A, B):
    "slope-intercept"
    fx, fy, gx, gy = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    near = 1e-10 * max(r, abs(fx), abs(fy), abs(gx), abs(gy))
    if A == B:
        return None
    # + slope-intercept: if fx == gx: return []
    # : An upright line, which has no slope, is answered with []. Work with the direction B − A.
    m = (gy - fy) / (gx - fx)
    # = m = (gy - fy) / ((gx - fx) or 1e-9)
    # = m = (gy - fy) / ((gx - fx) or 1e-12)
    n = fy - m * fx
    a, b, c = 1 + m * m, m * n, n * n - r * r
    d = abs(n) / sqrt(a)
    if d > r + near:
        return []
    s = sqrt(max(0.0, b * b - a * c))
    xs = [-b / a] if d >= r - near else [(-b - s) / a, (-b + s) / a]
    if gx < fx:
        xs = xs[::-1]
    # = pass
    return [(cx + x, cy + m * x + n) for x in xs]
