"""Programs that people write are given the right name, or none: each of these was once named wrongly."""

from __future__ import annotations

import pytest

from judge.judging import Session, Terms
from judge.problem.find import find_problem

pytestmark = pytest.mark.slow

TERMS = Terms(timed=False, diagnosed=False)

COUNT = """
from math import hypot


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    length = hypot(dx, dy)
    if length == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    d = abs(dx * fy - dy * fx) / length
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
"""
SEGMENT = """
from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    fx, fy = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    n = hypot(dx, dy)
    e = 1e-10 * max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    if n == 0:
        return [A] if abs(hypot(fx, fy) - r) <= e else []
    d = abs(dx * fy - dy * fx) / n
    if d > r + e:
        return []
    m = -(dx * fx + dy * fy) / n
    h = sqrt((r - d) * (r + d)) if d < r - e else 0
    places = [m - h, m + h] if h else [m]
    points = [(A[0] + s * dx / n, A[1] + s * dy / n) for s in places if -e <= s <= n + e]
    return points
"""
RAY = """
from math import hypot, sqrt


def ray_nearest(cx, cy, r, O, D):
    fx, fy = O[0] - cx, O[1] - cy
    n = hypot(*D)
    if n == 0:
        return None
    e = 1e-10 * max(r, abs(fx), abs(fy))
    k = abs(D[0] * fy - D[1] * fx) / n
    m = -(D[0] * fx + D[1] * fy) / n
    if k > r + e:
        return None
    roots = [m]
    if k < r - e:
        h = sqrt((r - k) * (r + k))
        far = m + h if m > 0 else m - h
        roots = sorted([far, (fx * fx + fy * fy - r * r) / far])
    for s in roots:
        if abs(s) <= e:
            return 0.0
        if s > 0:
            return s / n
    return None
"""
EXACT = """
def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    reach = r * r * (dx * dx + dy * dy)
    return 0 if k * k > reach else 1 if k * k == reach else 2
"""
SOURCES = {"count": COUNT, "segment": SEGMENT, "ray-nearest": RAY, "exact-count": EXACT}
EVERYTHING_ABSOLUTE = """
EPS = 1e-9


def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    fx, fy = A[0] - cx, A[1] - cy
    a = dx * dx + dy * dy
    if a < EPS:
        return None
    b, c = 2 * (fx * dx + fy * dy), fx * fx + fy * fy - r * r
    delta = b * b - 4 * a * c
    return 0 if delta < -EPS else 1 if delta < EPS else 2
"""
FRACTIONS = """
from fractions import Fraction as F


def line_count(cx, cy, r, A, B):
    if tuple(A) == tuple(B):
        return None
    px, py, qx, qy = F(A[0]) - F(cx), F(A[1]) - F(cy), F(B[0]) - F(cx), F(B[1]) - F(cy)
    k = px * qy - py * qx
    reach = F(r) ** 2 * ((qx - px) ** 2 + (qy - py) ** 2)
    return 0 if k * k > reach else 1 if k * k == reach else 2
"""
MEMO = """
kept = {}


def line_count(cx, cy, r, A, B):
    key = cx, cy, r
    if key not in kept:
        kept[key] = 2
    return kept[key]
"""

HELD = """
def held(x):
    return x if isinstance(x, float) else (x + 2**{0}) % 2**{1} - 2**{0}


"""
ROOTS = {
    "count": """
def line_count(cx, cy, r, A, B):
    fx, fy, dx, dy = A[0] - cx, A[1] - cy, B[0] - A[0], B[1] - A[1]
    if dx == 0 == dy:
        return None
    e = 1e-10 * max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    a, k = dx * dx + dy * dy, dx * fy - dy * fx
    rest = held(r * r * a - k * k) / a
    return 0 if rest < -e * (2 * r + e) else 1 if rest <= e * (2 * r + e) else 2
""",
    "segment": """
from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    fx, fy, dx, dy = A[0] - cx, A[1] - cy, B[0] - A[0], B[1] - A[1]
    e = 1e-10 * max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    if dx == 0 == dy:
        return [A] if abs(hypot(fx, fy) - r) <= e else []
    a, b, k = dx * dx + dy * dy, dx * fx + dy * fy, dx * fy - dy * fx
    rest = held(r * r * a - k * k) / a
    if rest < -e * (2 * r + e):
        return []
    h = sqrt(rest / a) if rest > e * (2 * r + e) else 0
    ts = [-b / a - h, -b / a + h] if h else [-b / a]
    e /= sqrt(a)
    return [(A[0] + t * dx, A[1] + t * dy) for t in ts if -e <= t <= 1 + e]
""",
    "ray-nearest": """
from math import sqrt


def ray_nearest(cx, cy, r, O, D):
    fx, fy, (dx, dy) = O[0] - cx, O[1] - cy, D
    if dx == 0 == dy:
        return None
    e = 1e-10 * max(r, abs(fx), abs(fy))
    a, b, k = dx * dx + dy * dy, dx * fx + dy * fy, dx * fy - dy * fx
    rest = held(r * r * a - k * k) / a
    if rest < -e * (2 * r + e):
        return None
    ts = [-b / a]
    if rest > e * (2 * r + e):
        far = -b - sqrt(rest * a) if b > 0 else -b + sqrt(rest * a)
        ts = sorted([far / a, (fx * fx + fy * fy - r * r) / far])
    for t in ts:
        if abs(t) * sqrt(a) <= e:
            return 0.0
        if t > 0:
            return t
    return None
""",
}  # right where whole numbers are held as they are

WRAPPED = "\n    return 0 if kk > reach else 1 if kk == reach else 2  #"

# what is changed in the right program, and the names that may be said of it
CHANGED = [
    ("count", "abs(d - r) <= 1e-10 * e", "abs(d - r) <= 1e-8 + 1e-5 * r", {"loose-epsilon"}),
    ("count", "d = abs(dx * fy - dy * fx) / length", "d = (dx * fy - dy * fx) / length", {"forgotten-abs"}),
    ("count", "    if abs(d", "    d = round(d, 6)\n    if abs(d", {"rounded-distance"}),
    ("count", "return 2 if d < r else 0", "return 0 if d < r else 2", {"swapped-answers"}),
    ("count", "dx, dy = B[0] - A[0], B[1] - A[1]", "dx, dy = B", {"point-for-direction"}),
    ("segment", "return points", "return points[0] if len(points) == 1 else points", {"point-not-in-a-list"}),
    (
        "segment",
        "return points",
        "return [(float('%.8f' % x), float('%.8f' % y)) for x, y in points]",
        {"rounded-output"},
    ),
    ("ray-nearest", "fx, fy = O[0] - cx, O[1] - cy", "fx, fy = cx - O[0], cy - O[1]", {"reversed-vector"}),
    (
        "ray-nearest",
        "    n = hypot",
        "    D = D[0] - O[0], D[1] - O[1]\n    n = hypot",
        {"target-for-direction"},
    ),
    (
        "ray-nearest",
        "    k = abs",
        "    if hypot(fx, fy) <= r + e:\n        return 0.0\n    k = abs",
        {"disc-for-circle"},
    ),
    ("ray-nearest", "(fx * fx + fy * fy - r * r)", "(fx * fx + fy * fy + r * r)", {"wrong-sign"}),
    ("ray-nearest", "return s / n", "return '%.15g' % (s / n)", {"text-for-a-value"}),
    (
        "exact-count",
        "    return 0",
        f"    kk, reach = ((v + 2**63) % 2**64 - 2**63 for v in (k * k, reach)){WRAPPED}",
        {"overflow-64"},
    ),
    (
        "exact-count",
        "    return 0",
        f"    kk, reach = ((v + 2**31) % 2**32 - 2**31 for v in (k * k, reach)){WRAPPED}",
        {"overflow-32"},
    ),
    ("exact-count", "return 0 if", "return 0. if", None),
]
WHOLE = [
    ("count", EVERYTHING_ABSOLUTE, {"absolute-epsilon"}),
    ("count", FRACTIONS, {"equality-tangency"}),
    ("count", "def line_count(cx, cy, r, A, B):\n    return 2\n", {"one-answer"}),
    (
        "count",
        COUNT.replace("return 2 if d < r else 0", "print(2 if d < r else 0)").replace(
            "return 1", "print(1)\n        return"
        ),
        {"print-for-return"},
    ),
    ("count", "def line_count(cx, cy, r, A, B):\n    return lines\n", None),
]


# what is changed in the right program, at two places, and both names
TWICE = [
    (
        "count",
        [
            ("d = abs(dx * fy - dy * fx)", "d = (dx * fy - dy * fx)"),
            ("2 if d < r else 0", "0 if d < r else 2"),
        ],
        {"forgotten-abs", "swapped-answers"},
    ),
    (
        "segment",
        [("-e <= s <= n + e", "0 < s < n"), ("return points", "return points or None"), ("[]", "None")],
        {"open-interval", "none-for-empty"},
    ),
    (
        "segment",
        [("[A] if abs(hypot(fx, fy) - r) <= e else []", "[]"), ("[m - h, m + h]", "[m + h, m - h]")],
        {"no-degenerate", "reversed-order"},
    ),
    (
        "ray-nearest",
        [("return s / n", "return s"), ("            return 0.0", "            continue")],
        {"distance-for-parameter", "origin-on-circle"},
    ),
]


@pytest.fixture(scope="module")
def named(built):
    """The names that a program of a problem is given."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("JUDGE_CACHE", str(built))
        sessions = {name: Session(find_problem(name), TERMS) for name in SOURCES}

        def names(problem, source):
            result = sessions[problem].judge(source.encode(), "mine.py")
            assert result.verdict.value != "AC"
            return result.pitfall and set(result.pitfall.names)

        yield names
        for session in sessions.values():
            session.__exit__(None, None, None)


@pytest.mark.parametrize(("problem", "old", "new", "wanted"), CHANGED)
def test_a_changed_line_is_named(named, problem, old, new, wanted):
    assert old in SOURCES[problem]
    assert named(problem, SOURCES[problem].replace(old, new)) == wanted


@pytest.mark.parametrize(("problem", "changes", "wanted"), TWICE)
def test_two_changed_lines_are_both_named(named, problem, changes, wanted):
    source = SOURCES[problem]
    for old, new in changes:
        assert old in source
        source = source.replace(old, new)
    assert named(problem, source) == wanted


@pytest.mark.parametrize(("problem", "source", "wanted"), WHOLE)
def test_a_whole_program_is_named(named, problem, source, wanted):
    assert named(problem, source) == wanted


@pytest.mark.parametrize("bits", [64, 32])
@pytest.mark.parametrize("problem", list(ROOTS))
def test_whole_numbers_of_a_fixed_width_are_named(named, problem, bits):
    held = HELD.format(bits - 1, bits)
    assert named(problem, held + ROOTS[problem]) == {f"overflow-{bits}"}


def test_kept_between_calls_is_not_said_of_what_fails_alone(named):
    assert named("count", MEMO) in (None, {"one-answer"})


def test_no_name_speaks_of_what_the_program_lacks(named):
    """It cuts the distance without a // in it."""
    cut = COUNT.replace("    if abs(d", "    d = int(d)\n    if abs(d")
    assert named("count", cut) in (None, {"whole-numbers"})
