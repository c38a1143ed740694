"""Right programs, and changes of them that make them wrong: what a repair must find, and where."""

from __future__ import annotations

from typing import NamedTuple

SEGMENT = """\
from math import hypot, sqrt

def circle_segment(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    size = max(r, abs(ax), abs(ay), abs(ax + dx), abs(ay + dy))
    slack = 1e-10 * size
    length = hypot(dx, dy)
    if length == 0:
        return [A] if abs(hypot(ax, ay) - r) <= slack else []
    ux, uy = dx / length, dy / length
    off = abs(ux * ay - uy * ax)
    foot = -(ux * ax + uy * ay)
    if off > r + slack:
        return []
    half = sqrt((r - off) * (r + off)) if off < r - slack else 0
    found = []
    for s in sorted({foot - half, foot + half}):
        if -slack <= s <= length + slack:
            found.append((A[0] + s * ux, A[1] + s * uy))
    return found
"""
COUNT = """\
from math import hypot

def line_count(cx, cy, r, A, B):
    ax, ay, bx, by = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    if A == B:
        return None
    size = max(r, abs(ax), abs(ay), abs(bx), abs(by))
    px, py = (ax, ay) if hypot(ax, ay) < hypot(bx, by) else (bx, by)
    length = hypot(B[0] - A[0], B[1] - A[1])
    ux, uy = (B[0] - A[0]) / length, (B[1] - A[1]) / length
    off = abs(ux * py - uy * px)
    if abs(off - r) <= 1e-10 * size:
        return 1
    return 2 if off < r else 0
"""
RAY = """\
from math import hypot, sqrt

def ray_nearest(cx, cy, r, O, D):
    fx, fy = O[0] - cx, O[1] - cy
    length = hypot(D[0], D[1])
    if length == 0:
        return None
    ux, uy = D[0] / length, D[1] / length
    slack = 1e-10 * max(r, abs(fx), abs(fy))
    off = abs(ux * fy - uy * fx)
    foot = -(ux * fx + uy * fy)
    if off > r + slack:
        return None
    half = sqrt((r - off) * (r + off)) if off < r - slack else 0.0
    for s in (foot - half, foot + half):
        if s >= -slack:
            return max(0.0, s) / length
    return None
"""
FIRST = """\
from math import sqrt

def circle_segment(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    fx, fy = A[0] - cx, A[1] - cy
    a = dx * dx + dy * dy
    if a == 0:
        return []
    b = fx * dx + fy * dy
    disc = b * b - a * (fx * fx + fy * fy - r * r)
    if disc < 0:
        return []
    found = []
    for t in ((-b - sqrt(disc)) / a, (-b + sqrt(disc)) / a):
        if 0 <= t <= 1:
            found.append((A[0] + t * dx, A[1] + t * dy))
    return found
"""
PROGRAMS = {"segment": SEGMENT, "count": COUNT, "ray-nearest": RAY}


class Wrong(NamedTuple):
    """A right program with other lines in it, and what is to be found: a kind, and its line."""

    kata: str
    old: str
    new: str
    kind: str
    line: int

    @property
    def text(self) -> str:
        """The wrong program."""
        right = PROGRAMS[self.kata]
        assert right.count(self.old) == 1
        return right.replace(self.old, self.new)


OUT = "    if hypot(ax, ay) > r < hypot(ax + dx, ay + dy):\n        return []\n"
WHOLE = "    A = tuple(map(int, A))\n"
KEPT = "r, A, B, seen=[]):\n    seen.append(A)\n    A = seen[0]\n"
ENDED = "        if not -slack <= s <= length + slack:\n            break\n        if True:\n"
PARTS = "    f, u = complex(ax, ay), complex(ux, uy)\n    off = abs(u.real * f.imag - u.imag * f.imag)"
REST = " <= 1e-10 * size:\n        return 1\n    return 2 if "
SIDE = f"    off = abs(ux * py - uy * px)\n    if abs(off - r){REST}off < r"
GAP = f"    off = ux * py - uy * px - r\n    if abs(off){REST}off < 0"
SHARED = "    p = [ax, ay]\n    q = p\n    q[0] += dx\n    ax, slack"
BEHIND = "    if foot < 0:\n        return None\n"
WRONG = [
    Wrong("segment", "-slack <= s <= length + slack", "0 <= s <= length", "room", 19),
    Wrong("segment", "-slack <= s <= length + slack", "s <= length + slack", "filter", 21),
    Wrong("segment", "-slack <= s <= length + slack", "True", "filter", 21),
    Wrong("segment", "sorted({foot - half, foot + half})", "(foot - half, foot + half)", "once", 21),
    Wrong("segment", "foot + half})", "foot + half}, reverse=True)", "order", 18),
    Wrong("segment", "1e-10 * size", "1e-9", "tolerance-scaled", 7),
    Wrong("segment", "1e-10 * size", "1e-6 * size", "tolerance-smaller", 7),
    Wrong("segment", "[A] if abs(hypot(ax, ay) - r) <= slack else []", "[]", "guard-same:A=B", 10),
    Wrong("segment", "-(ux * ax + uy * ay)", "ux * ax + uy * ay", "sign", 13),
    Wrong("segment", "ux * ay - uy * ax", "ux * ax - uy * ay", "name", 12),
    Wrong("segment", "(r - off) * (r + off)", "r - off * off", "square", 16),
    Wrong("segment", "(r - off) * (r + off)", "r - off", "measure", 16),
    Wrong("segment", "sqrt((r - off) * (r + off))", "(r - off)", "measure", 16),
    Wrong("segment", "(r - off) * (r + off)", "(r - off) * r + off", "brackets", 16),
    Wrong("segment", "        if -slack <= s <= length + slack:\n", ENDED, "early", 20),
    Wrong("segment", "    off = abs(ux * ay - uy * ax)", PARTS, "name", 13),
    Wrong("segment", "off > r + slack", "off > r", "room", 14),
    Wrong("segment", "off > r + slack", "off < r + slack", "compare-turned", 14),
    Wrong("segment", "return found", "return [(round(x, 6), y) for x, y in found]", "without-round", 21),
    Wrong(
        "segment", "if -slack <= s <= length + slack", "if (s := min(length, max(0, s))) > -1", "clamp", 19
    ),
    Wrong("segment", "if length == 0:", "if length < 1e-3 * size:", "guard-exact", 9),
    Wrong("segment", "A[0] + s * ux, A[1] + s * uy", "A[1] + s * uy, A[0] + s * ux", "coordinates", 20),
    Wrong("segment", "A[0] + s * ux, A[1] + s * uy", "ax + s * ux, ay + s * uy", "moved", 0),
    Wrong("segment", "    ux, uy", OUT + "    ux, uy", "guard-left-out", 11),
    Wrong("segment", "cx, cy, r, A, B", "A, B, cx, cy, r", "parameter-order", 3),
    Wrong("count", "abs(off - r) <= 1e-10 * size", "off == r", "near", 12),
    Wrong("count", "abs(off - r) <= 1e-10 * size", "abs(off - r) <= 1e-10", "tolerance-scaled", 12),
    Wrong("count", "1e-10 * size", "1e-5 * size", "tolerance-smaller", 12),
    Wrong("count", "2 if off < r else 0", "2 if off > r else 0", "compare-turned", 14),
    Wrong("count", "2 if off < r else 0", "0 if off < r else 2", "compare-turned", 14),
    Wrong("count", "return None", "return 0", "guard-same:A=B", 6),
    Wrong("count", "A == B:", "A == B or r == 0:", "guard-zero:r=0", 6),
    Wrong("count", "abs(ux * py - uy * px)", "ux * py - uy * px", "abs", 11),
    Wrong("count", SIDE, GAP, "abs", 11),
    Wrong("count", "cx, cy, r, A, B", "A, B, cx, cy, r", "parameter-order", 3),
    Wrong("count", "abs(ax), abs(ay), abs(bx)", "abs(A[0]), abs(A[1]), abs(bx)", "tolerance-scaled", 12),
    Wrong("count", "r, A, B):\n", KEPT, "fresh", 0),
    Wrong("count", "    ax, ay, bx", WHOLE + "    ax, ay, bx", "statement-left-out", 4),
    Wrong("ray-nearest", "(foot - half, foot + half)", "(foot + half, foot - half)", "coordinates", 15),
    Wrong("ray-nearest", "(foot - half, foot + half)", "(foot - half, half)", "missing", 15),
    Wrong("segment", "    slack = 1e-10 * size", f"{SHARED} = p[0], 1e-10 * size", "copied", 8),
    Wrong("ray-nearest", "max(0.0, s) / length", "max(0.0, s)", "measure", 17),
    Wrong("ray-nearest", "hypot(D[0], D[1])", "max(abs(D[0]), abs(D[1]))", "measure", 5),
    Wrong("ray-nearest", "ux, uy = D[0] / length,", "ux, uy = 2 * D[0] / length,", "measure", 8),
    Wrong("ray-nearest", "s >= -slack", "-slack <= s <= length + slack", "name", 16),
    Wrong("ray-nearest", "    half", BEHIND + "    half", "guard-left-out", 14),
    Wrong("ray-nearest", "-(ux * fx + uy * fy)", "ux * fx + uy * fy", "sign", 11),
    Wrong("ray-nearest", "length == 0:", "length == 0 or r == 0:", "guard-zero:r=0", 7),
    Wrong("ray-nearest", "O[0] - cx, O[1] - cy", "O[0], O[1]", "moved", 0),
]
