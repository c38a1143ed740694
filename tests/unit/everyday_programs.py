"""Wrong programs as people write them, each in a way of its own, with the names that may be said of it.

None follows the routes of solutions/*/mistakes.py: other formulas, other names, other orders.
"""

from __future__ import annotations

# problem, the name it must be given, the program
NAMED = [
    (
        "count",
        "loose-epsilon",
        """
import numpy as np

def line_count(cx, cy, r, A, B):
    a, b, c = (np.array(p, dtype=float) for p in (A, B, (cx, cy)))
    if (a == b).all():
        return None
    u = (b - a) / np.linalg.norm(b - a)
    h = np.linalg.norm((c - a) - np.dot(c - a, u) * u)
    return 1 if np.isclose(h, r) else 2 if h < r else 0
""",
    ),
    (
        "count",
        "rounded-distance",
        """
def line_count(cx, cy, r, A, B):
    if A[0] == B[0] and A[1] == B[1]:
        return None
    p, q = B[1] - A[1], A[0] - B[0]
    away = round(abs(p * (cx - A[0]) + q * (cy - A[1])) / (p * p + q * q) ** 0.5, 6)
    if away > r:
        return 0
    return 2 - (away == r)
""",
    ),
    (
        "count",
        "forgotten-abs",
        """
from math import sqrt

def line_count(cx, cy, r, A, B):
    p, q = A[1] - B[1], B[0] - A[0]
    if p == q == 0:
        return None
    height = (p * (cx - A[0]) + q * (cy - A[1])) / sqrt(p * p + q * q)
    size = max(r, *(abs(z - w) for point in (A, B) for z, w in zip(point, (cx, cy))))
    over = height - r
    return 2 if over < -size / 1e10 else int(over <= size / 1e10)
""",
    ),
    (
        "count",
        "point-for-direction",
        """
import math

def line_count(cx, cy, r, A, B):
    if A == B:
        return None
    scale = max([r] + [abs(v) for v in (A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy)])
    angle = math.atan2(B[1], B[0])
    away = abs((cx - A[0]) * math.sin(angle) - (cy - A[1]) * math.cos(angle))
    if abs(away - r) < scale * 1e-10:
        return 1
    return 0 if away > r else 2
""",
    ),
    (
        "count",
        "equality-tangency",
        """
from fractions import Fraction

def line_count(*numbers):
    cx, cy, r, A, B = numbers
    x1, y1, x2, y2 = (Fraction(v) - Fraction(w) for v, w in zip((*A, *B), (cx, cy, cx, cy)))
    if (x1, y1) == (x2, y2):
        return None
    a = (x2 - x1) ** 2 + (y2 - y1) ** 2
    b = 2 * (x1 * (x2 - x1) + y1 * (y2 - y1))
    c = x1 ** 2 + y1 ** 2 - Fraction(r) ** 2
    root = b * b - 4 * a * c
    return 1 + (root > 0) - (root < 0)
""",
    ),
    (
        "count",
        "absolute-epsilon",
        """
EPS = 1e-9

def sign(x):
    return 0 if abs(x) < EPS else 1 if x > 0 else -1

def line_count(cx, cy, r, A, B):
    (x1, y1), (x2, y2) = A, B
    if sign(x1 - x2) == 0 and sign(y1 - y2) == 0:
        return None
    area = (x1 - cx) * (y2 - cy) - (x2 - cx) * (y1 - cy)
    side = ((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5
    return 1 + sign(r - abs(area) / side)
""",
    ),
    ("count", "one-answer", "def line_count(cx, cy, r, A, B):\n    return 2 if r >= 0 else 0\n"),
    (
        "count",
        "swapped-answers",
        """
from math import dist

def line_count(cx, cy, r, A, B):
    if A == B:
        return None
    twice = abs((A[0] - cx) * (B[1] - A[1]) - (A[1] - cy) * (B[0] - A[0]))
    slack = max(r, *(abs(point[i] - c) for point in (A, B) for i, c in enumerate((cx, cy))))
    margin = twice / dist(A, B) - r
    if -1e-10 * slack <= margin <= 1e-10 * slack:
        return 1
    return 2 if margin > 0 else 0
""",
    ),
    (
        "exact-count",
        "swapped-answers",
        """
def exact_count(cx, cy, r, A, B):
    if A == B:
        return None
    across = (A[0] - cx) * (B[1] - cy) - (A[1] - cy) * (B[0] - cx)
    reach = r * r * ((A[0] - B[0]) ** 2 + (A[1] - B[1]) ** 2)
    if across ** 2 == reach:
        return 1
    return 2 if across ** 2 > reach else 0
""",
    ),
    (
        "exact-count",
        "overflow-32",
        """
def c_int(x):
    return ((x & 0xFFFFFFFF) ^ 0x80000000) - 0x80000000

def exact_count(cx, cy, r, A, B):
    if A == B:
        return None
    x, y = c_int(A[0] - cx), c_int(A[1] - cy)
    dx, dy = c_int(B[0] - A[0]), c_int(B[1] - A[1])
    k = c_int(c_int(dx * y) - c_int(dy * x))
    n = c_int(c_int(dx * dx) + c_int(dy * dy))
    left, right = c_int(k * k), c_int(c_int(r * r) * n)
    return 2 if left < right else 1 if left == right else 0
""",
    ),
    (
        "exact-count",
        "overflow-64",
        """
M = 1 << 64

def s64(x):
    x %= M
    return x - M if x >= M // 2 else x

def exact_count(cx, cy, r, A, B):
    if A == B:
        return None
    x, y, z, w = s64(A[0] - cx), s64(A[1] - cy), s64(B[0] - cx), s64(B[1] - cy)
    k = s64(s64(x * w) - s64(y * z))
    n = s64(s64((z - x) ** 2) + s64((w - y) ** 2))
    left, right = s64(k * k), s64(s64(r * r) * n)
    return 2 if left < right else 1 if left == right else 0
""",
    ),
    (
        "exact-count",
        "point-for-direction",
        """
def exact_count(cx, cy, r, A, B):
    if A == B:
        return None
    vx, vy = B
    n = vx * vx + vy * vy
    dot = (cx - A[0]) * vx + (cy - A[1]) * vy
    far = ((cx - A[0]) ** 2 + (cy - A[1]) ** 2) * n - dot * dot
    return 1 if far == r * r * n else 2 if far < r * r * n else 0
""",
    ),
    (
        "exact-count",
        "print-for-return",
        """
def exact_count(cx, cy, r, A, B):
    k = (A[0] - cx) * (B[1] - cy) - (A[1] - cy) * (B[0] - cx)
    n = (A[0] - B[0]) ** 2 + (A[1] - B[1]) ** 2
    if n:
        print(1 + (k * k < r * r * n) - (k * k > r * r * n))
    else:
        print(None)
""",
    ),
    (
        "segment",
        "point-not-in-a-list",
        """
from cmath import polar, rect

def circle_segment(cx, cy, r, A, B):
    a, b = complex(A[0] - cx, A[1] - cy), complex(B[0] - cx, B[1] - cy)
    slack = 1e-10 * max(r, *(abs(v) for z in (a, b) for v in (z.real, z.imag)))
    if A == B:
        return tuple(A) if abs(abs(a) - r) <= slack else []
    span, turn = polar(complex(B[0] - A[0], B[1] - A[1]))
    local = a * rect(1, -turn)
    off = abs(local.imag)
    if off > r + slack:
        return []
    half = 0.0 if off > r - slack else ((r - off) * (r + off)) ** 0.5
    steps = sorted({-local.real - half, -local.real + half})
    found = [rect(s, turn) for s in steps if -slack <= s <= span + slack]
    found = [(A[0] + z.real, A[1] + z.imag) for z in found]
    return found[0] if len(found) == 1 else found
""",
    ),
    (
        "segment",
        "rounded-output",
        """
import math

def show(x):
    return float("%.8f" % x)

def circle_segment(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    px, py = A[0] - cx, A[1] - cy
    tiny = 1e-10 * max(map(abs, (r, px, py, B[0] - cx, B[1] - cy)))
    n = math.hypot(dx, dy)
    if not n:
        return [A] if abs(math.hypot(px, py) - r) <= tiny else []
    ux, uy = dx / n, dy / n
    off, foot = px * uy - py * ux, -px * ux - py * uy
    qx, qy = off * uy, -off * ux
    if abs(off) >= r - tiny:
        places = [foot] if abs(off) <= r + tiny else []
    else:
        w = math.sqrt(r - abs(off)) * math.sqrt(r + abs(off))
        places = [foot - w, foot + w]
    return [
        (show(cx + qx + (s - foot) * ux), show(cy + qy + (s - foot) * uy))
        for s in places
        if -tiny <= s <= n + tiny
    ]
""",
    ),
    (
        "segment",
        "inside-ends",
        """
from math import hypot, sqrt

def circle_segment(cx, cy, r, A, B):
    # the part of the segment inside the circle: where it begins and where it ends
    x, y = A[0] - cx, A[1] - cy
    e = 1e-10 * max(r, abs(x), abs(y), abs(B[0] - cx), abs(B[1] - cy))
    n = hypot(B[0] - A[0], B[1] - A[1])
    if n == 0:
        return [A] if hypot(x, y) <= r + e else []
    u, v = (B[0] - A[0]) / n, (B[1] - A[1]) / n
    d, m = abs(x * v - y * u), -(x * u + y * v)
    if d > r + e:
        return []
    h = sqrt((r - d) * (r + d)) if d < r - e else 0.0
    first, last = max(m - h, 0.0), min(m + h, n)
    if first > last + e:
        return []
    ends = [first] if last - first <= e else [first, last]
    return [(A[0] + s * u, A[1] + s * v) for s in ends]
""",
    ),
    (
        "segment",
        "absolute-epsilon",
        """
from math import sqrt

eps = 1e-9

def circle_segment(cx, cy, r, A, B):
    (x1, y1), (x2, y2) = A, B
    if abs(x1 - x2) < eps and abs(y1 - y2) < eps:
        return [(x1, y1)] if abs(sqrt((x1 - cx) ** 2 + (y1 - cy) ** 2) - r) < eps else []
    length = sqrt((x2 - x1) ** 2 + (y2 - y1) ** 2)
    ux, uy = (x2 - x1) / length, (y2 - y1) / length
    s = (cx - x1) * ux + (cy - y1) * uy
    fx, fy = x1 + s * ux, y1 + s * uy
    d = sqrt((fx - cx) ** 2 + (fy - cy) ** 2)
    if d > r + eps:
        return []
    if abs(d - r) < eps:
        return [(fx, fy)] if -eps <= s <= length + eps else []
    h = sqrt(r * r - d * d)
    return [(x1 + q * ux, y1 + q * uy) for q in (s - h, s + h) if -eps <= q <= length + eps]
""",
    ),
    (
        "ray-nearest",
        "reversed-vector",
        """
from math import copysign, sqrt

def ray_nearest(cx, cy, r, O, D):
    to = cx - O[0], cy - O[1]
    a = D[0] ** 2 + D[1] ** 2
    if not a:
        return None
    slack = 1e-10 * max(r, abs(to[0]), abs(to[1]))
    half_b = to[0] * D[0] + to[1] * D[1]
    off = abs(to[0] * D[1] - to[1] * D[0]) / sqrt(a)
    if off > r + slack:
        return None
    if off >= r - slack:
        answers = [-half_b / a]
    else:
        q = -half_b - copysign(sqrt(a * (r - off) * (r + off)), half_b)
        answers = sorted((q / a, (to[0] ** 2 + to[1] ** 2 - r ** 2) / q))
    for t in answers:
        if abs(t) * sqrt(a) <= slack:
            return 0
        if t > 0:
            return t
""",
    ),
    (
        "ray-nearest",
        "rounded-output",
        """
from math import dist, hypot, sqrt

def ray_nearest(cx, cy, r, O, D):
    long = hypot(*D)
    if long == 0:
        return None
    w, z = (cx - O[0]) / 1, (cy - O[1]) / 1
    ahead, aside = (w * D[0] + z * D[1]) / long, abs(w * D[1] - z * D[0]) / long
    eps = max(r, abs(w), abs(z)) * 1e-10
    if aside > r + eps:
        return None
    deep = 0 if aside > r - eps else sqrt((r - aside) * (r + aside))
    far = ahead + deep if ahead >= 0 else ahead - deep
    both = [ahead] if not deep else sorted([far, (w * w + z * z - r * r) / far])
    for s in both:
        if s >= -eps:
            return float("%.8f" % (max(s, 0) / long)) if s > eps else 0
    return None
""",
    ),
    (
        "ray-nearest",
        "disc-for-circle",
        """
from math import hypot, sqrt

def ray_nearest(cx, cy, r, O, D):
    n = hypot(D[0], D[1])
    if n == 0:
        return None
    x, y = O[0] - cx, O[1] - cy
    eps = 1e-10 * max(r, abs(x), abs(y))
    if x * x + y * y <= (r + eps) ** 2:
        return 0.0  # already there
    along, across = -(x * D[0] + y * D[1]) / n, abs(x * D[1] - y * D[0]) / n
    if along < 0 or across > r + eps:
        return None
    chord = sqrt((r - across) * (r + across)) if across < r - eps else 0.0
    return (x * x + y * y - r * r) / (along + chord) / n if chord else along / n
""",
    ),
    (
        "ray-nearest",
        "wrong-sign",
        """
import math

def ray_nearest(cx, cy, r, O, D):
    px, py = O[0] - cx, O[1] - cy
    A, B, C = D[0] ** 2 + D[1] ** 2, 2 * (px * D[0] + py * D[1]), px ** 2 + py ** 2 + r ** 2
    if A == 0:
        return None
    disc = B ** 2 - 4 * A * C
    if disc < 0:
        return None
    roots = sorted([(-B - math.sqrt(disc)) / (2 * A), (-B + math.sqrt(disc)) / (2 * A)])
    limit = 1e-10 * max(r, abs(px), abs(py)) / math.sqrt(A)
    good = [t for t in roots if t > -limit]
    return max(good[0], 0) if good else None
""",
    ),
    (
        "ray-nearest",
        "target-for-direction",
        """
from math import hypot, sqrt

def ray_nearest(cx, cy, r, P, Q):
    vx, vy = Q[0] - P[0], Q[1] - P[1]
    size = hypot(vx, vy)
    if size == 0:
        return None
    gx, gy = cx - P[0], cy - P[1]
    eps = 1e-10 * max(r, abs(gx), abs(gy))
    m, k = (gx * vx + gy * vy) / size, abs(gx * vy - gy * vx) / size
    if k > r + eps:
        return None
    h = 0 if k > r - eps else sqrt(r - k) * sqrt(r + k)
    for s in (m - h, m + h):
        if abs(s) <= eps:
            return 0
        if s > 0:
            return s / size
""",
    ),
    (
        "ray-nearest",
        "absolute-epsilon",
        """
from math import sqrt

def ray_nearest(cx, cy, r, O, D, eps=1e-9):
    a = D[0] * D[0] + D[1] * D[1]
    if a < eps:
        return None
    fx, fy = O[0] - cx, O[1] - cy
    b, c = fx * D[0] + fy * D[1], fx * fx + fy * fy - r * r
    delta = b * b - a * c
    if delta < -eps:
        return None
    root = sqrt(delta) if delta > eps else 0
    for t in ((-b - root) / a, (-b + root) / a):
        if t > -eps:
            return t if t > eps else 0
    return None
""",
    ),
    (
        "ray-nearest",
        "sentinel-miss",
        """
from math import hypot, sqrt

def ray_nearest(cx, cy, r, O, D):
    n = hypot(*D)
    if n == 0:
        return None
    x, y = O[0] - cx, O[1] - cy
    eps = max(r, abs(x), abs(y)) * 2e-10
    k, m = abs(x * D[1] - y * D[0]) / n, -(x * D[0] + y * D[1]) / n
    if k - r > eps:
        return -1
    h = sqrt((r - k) * (r + k)) if r - k > eps else 0
    far = m + h if m > 0 else m - h
    for s in sorted((far, (x * x + y * y - r * r) / far)) if h else [m]:
        if -eps < s < eps:
            return 0
        if s > 0:
            return s / n
    return None
""",
    ),
]

# wrong in ways that no name tells: whatever fits a little is not what they do
SILENT = [
    (
        "count",
        """
from math import hypot

def line_count(cx, cy, r, A, B):
    if A[0] == B[0] and abs(A[1] - B[1]) < 1e-15:
        return None
    p, q, s, t = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    gap = abs(dx * q - dy * p) / hypot(dx, dy) - r
    tol = 1e-10 * max(abs(p), abs(q), abs(s), abs(t), r)
    return 1 if abs(gap) < tol else 2 if gap < 0 else 0
""",
    ),
]
COUNTED = """
from math import hypot

def line_count(cx, cy, r, A, B):
    if A == B: return None
    x, y, u, v = A[0] - cx, A[1] - cy, B[0] - A[0], B[1] - A[1]
    d = abs(u * y - v * x) / hypot(u, v)
    e = 1e-10 * max(r, abs(x), abs(y), abs(B[0] - cx), abs(B[1] - cy))
    if d < r - e: return 2
    return 1 if d <= r + e else 0
"""
COUNTED_EXACTLY = """
def exact_count(cx, cy, r, A, B):
    if A == B: return None
    x, y, u, v = A[0] - cx, A[1] - cy, B[0] - A[0], B[1] - A[1]
    k = u * y - v * x
    over = k * k - r * r * (u * u + v * v)
    return 0 if over > 0 else 2 if over < 0 else 1
"""
RAY = """
from math import hypot, sqrt

def ray_nearest(cx, cy, r, O, D):
    f, g = O[0] - cx, O[1] - cy
    n = hypot(*D)
    if n == 0: return None
    e = 1e-10 * max(r, abs(f), abs(g))
    u, v = D[0] / n, D[1] / n
    m, k = -(f * u + g * v), abs(f * v - g * u)
    if k > r + e: return None
    h = sqrt((r - k) * (r + k)) if k < r - e else 0
    far = m + h if m > 0 else m - h
    for s in sorted([far, (f * f + g * g - r * r) / far]) if h else [m]:
        if abs(s) <= e: return 0
        if s > 0: return s / n
    return None
"""
# what stands in the right program, and instead of it
_ODD = [
    ("count", COUNTED, "hypot(u, v)", "hypot(x, y)"),
    ("count", COUNTED, "hypot(u, v)", "max(abs(u), abs(v))"),
    ("count", COUNTED, "    d =", "    x = abs(x)\n    d ="),
    ("count", COUNTED, "A == B", "A == B or cx == cy"),
    ("count", COUNTED, "    e =", "    r += 1\n    e ="),
    ("count", COUNTED, "return 2", "return 2 if r > 1e-6 else 1"),
    ("exact-count", COUNTED_EXACTLY, "v * x", "v * x * 2"),
    ("exact-count", COUNTED_EXACTLY, "v * x", "v * x + 1"),
    ("exact-count", COUNTED_EXACTLY, "r * r", "(r + 1) ** 2"),
    ("exact-count", COUNTED_EXACTLY, "r * r", "r ** 3"),
    ("exact-count", COUNTED_EXACTLY, "u * u + v * v", "(u + v) ** 2"),
    ("exact-count", COUNTED_EXACTLY, "    k =", "    if u < 0: return 0\n    k ="),
    ("ray-nearest", RAY, "s / n", "s * n if v < 0 else s / n"),
    ("ray-nearest", RAY, "s / n", "s / n if s < 2 * r else (s - r) / n"),
    ("ray-nearest", RAY, "s / n", "min(s / n, 1)"),
]
SILENT += [(problem, right.replace(old, new)) for problem, right, old, new in _ODD]
