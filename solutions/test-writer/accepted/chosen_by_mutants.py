"""chosen by mutants

A pool of candidates is made from a few figures, and a solver of one's own is broken on purpose in many ways. Each
candidate is asked which of the broken solvers answer it otherwise than the sound one; then the cases are chosen one by
one, always the one that tells most of those that are left. This is mutation testing, with the tests chosen by it.
"""

from itertools import product
from math import hypot, sqrt


def solver(near=1e-10, ends=1e-10, size="all", degenerate=None, half=1.0, order=1, keep=True, digits=None, form=0):
    """A solver, sound without arguments, and the parts of it that may be broken."""
    degenerate = near if degenerate is None else degenerate

    def solve(cx, cy, r, A, B):
        ax, ay, bx, by = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
        dx, dy = bx - ax, by - ay
        sizes = {
            "all": max(r, abs(ax), abs(ay), abs(bx), abs(by)),
            "one": 1.0,
            "radius": r,
            "length": hypot(dx, dy),
            "begin": max(r, abs(ax), abs(ay)),
            "signed": max(r, ax, ay, bx, by),
            "plane": max(r, *map(abs, (*A, *B, cx, cy))),
        }
        e = sizes[size]
        length = hypot(dx, dy)
        if length == 0 or (form == 1 and length < 1e-9):
            on = abs(hypot(ax, ay) - r) <= degenerate * e
            return [(A[0], A[1])] if on and form != 2 else []
        if form == 3 and r == 0:
            return []
        if form == 4:  # in the plane's own frame
            p, q = -dy / length, dx / length
            d = p * cx + q * cy - (p * A[0] + q * A[1])
        elif form == 5:  # without regard to lost digits
            d = sqrt(max(0.0, (ax * ax + ay * ay) * (bx * bx + by * by) - (ax * bx + ay * by) ** 2)) / length
        else:
            d = abs(dx * ay - dy * ax) / length
        if d > r + near * e:
            return [] if form != 6 else [(A[0], A[1])]
        foot = -(ax * dx + ay * dy) / length
        if d >= r - near * e:
            along = [foot] if form != 7 else []
        else:
            h = half * sqrt(max(0.0, r * r - d * d))
            along = [foot - h, foot + h][::order]
        slack = ends * e
        if keep:
            along = [s for s in along if -slack <= s <= length + slack]
        found = [(A[0] + s / length * dx, A[1] + s / length * dy) for s in along]
        return found if digits is None else [(round(x, digits), round(y, digits)) for x, y in found]

    return solve


def wrapped(case, bits):
    """Whether whole numbers of so many bits overflow where the case is multiplied out."""
    cx, cy, r, A, B = case
    if not all(isinstance(x, int) for x in (cx, cy, r, *A, *B)):
        return False
    d = max(abs(B[0] - A[0]), abs(B[1] - A[1]))
    return d * d * max(1, r * r) >= 1 << (bits - 1)


MUTANTS = [
    *(solver(near, near) for near in (3e-16, 1e-14, 1e-6, 1e-5)),
    *(solver(ends=ends) for ends in (-1e-9, 0.0, 1e-14, 1e-6, 1e-5)),
    *(solver(size=size) for size in ("radius", "length", "begin", "signed", "plane")),
    *(solver(near, near, size="one") for near in (1e-9, 1e-7)),
    *(solver(degenerate=each) for each in (1e-14, 1e-13, 1e-5)),
    *(solver(form=form) for form in range(1, 8)),
    solver(half=0.5), solver(order=-1), solver(keep=False), solver(digits=6), solver(digits=0),
]  # fmt: skip


def differs(found, wanted, e):
    if len(found) != len(wanted):
        return True
    return any(abs(x - y) > 3e-9 * e for f, w in zip(found, wanted) for x, y in zip(f, w))


def moved(case, turn, scale, shift):
    cx, cy, r, A, B = case
    p, q, length = turn

    def image(x, y):
        return (p * x - q * y) * scale + shift[0], (q * x + p * y) * scale + shift[1]

    return (*image(cx, cy), r * length * scale, image(*A), image(*B))


def pool():
    figures = [
        (2, 1, 5, (9, 4), (-7, -2)),
        (2, 1, 5, (2, 1), (-20, -23)),
        (0, 0, 5, (3, 4), (-4.99999, 0)),
        (0, 0, 5, (3, 4), (3, -9)),
        (0, 0, 1, (-3, 1), (4, 1)),
        (0, 0, 1, (2, 1), (4, 1)),
        (0, 0, 1, (-2, -1.000001), (2, -1.000001)),
        (0, 0, 5, (3, 4), (3, 4)),
        (0, 0, 5, (3, 4.00001), (3, 4.00001)),
        (0, 0, 0, (-1, -1), (2, 2)),
        (0, 0, 5, (0, 1), (2, 1)),
    ]
    turns, scales = [(1, 0, 1), (20, 21, 29)], [1, 0.1, 2**-32, 3_000_000]
    for figure, turn, scale in product(figures, turns, scales):
        yield moved(figure, turn, scale, (0, 0) if scale < 1e-3 else (scale * 7e4, scale * 3))
    yield (0, 0, 5, (3, 3.999999), (-3000000, -4000003))
    yield (0, 0, 151, (-277426592.2, 369902374.6), (277426833.8, -369902193.4))
    yield moved(figures[1], (1, 0, 1), 0.1, (8e7, -9e7))
    yield moved(figures[0], (1, 0, 1), 101_000_000, (0, 0))
    yield (0, 0, 2e-9, (0, -1.8e-9), (0, -2.2e-9))


def told(case):
    """The places of the mutants that the case tells from the sound solver, and the kinds of slips it shows."""
    cx, cy, r, A, B = case
    e = max(r, abs(A[0] - cx), abs(A[1] - cy), abs(B[0] - cx), abs(B[1] - cy))
    right = solver()(*case)
    found = {at for at, mutant in enumerate(MUTANTS) if differs(mutant(*case), right, e)}
    found |= {f"{bits} bits" for bits in (32, 64) if wrapped(case, bits) and len(right) == 2}
    if len(right) == 2 and r < 100:
        found |= {"falls" if right[0][0] > right[1][0] else "rises"}
    if A != B and abs((B[0] - A[0]) * (A[0] - cx) + (B[1] - A[1]) * (A[1] - cy)) == 0:
        found.add("from the foot")
    if not right and A != B:
        left = (B[0] - A[0]) * (cy - A[1]) - (B[1] - A[1]) * (cx - A[0])
        found.add(f"missed on the {'left' if left > 0 else 'right'}")
    if len(right) == 2 and A[0] != B[0] and A[1] != B[1] and cx != cy:
        found.add("slanted")
    if len(right) == 1 and r == 0:
        found.add("point circle")
    if A == B and not right and e < 1e-8:
        found.add("tiny, beside the circle")
    if A[0] == B[0] and A != B and len(right) < len(solver(keep=False)(*case)):
        found.add("upright, cut short")
    if differs(solver(ends=1e-5)(*case), right, e) and r > e / 9:
        found.add("just short of the circle")
    if e < 100 and abs(cx) > 1e7:
        found.add("far away")
    return found


def cases():
    left = {}
    for case in pool():
        left.setdefault(case, told(case))
    wanted, chosen = set().union(*left.values()), []
    while wanted and len(chosen) < 12:
        best = max(left, key=lambda case: len(left[case] & wanted))
        chosen.append(best)
        wanted -= left[best]
    return chosen
