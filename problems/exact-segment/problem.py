"""The common points of a circle and a closed segment in ints of any size, counted by signs alone."""

from judge.geometry import whole
from judge.geometry.hooks import hooks
from judge.geometry.scenes import AXIS, PLAIN, either, grid, hairlines, lines, signs, tried
from judge.problem.declare import group

HOOKS = hooks("count in a segment")
INT, WIDE = {**PLAIN, "numbers": "int"}, {**PLAIN, "numbers": "int", "size": 1000}
ENDS = ("chord first in", "chord first after", "chord before first", "chord first last", "chord last after", "chord in last")


def solve(cx, cy, r, A, B):
    return whole.count_segment(cx, cy, r, A, B)


def one_point(draw):
    """A = B, on the circle or off it by the least there is."""
    cx, cy, r, A, _ = hairlines.ends((10**3, 10**9, 10**30), 0, 1, -1)(draw)
    return cx, cy, r, A, A


def over_foot(draw):
    """Δ = 1 or -1 where r²a − k² has up to 480 digits, and the foot is on the segment."""
    cx, cy, r, A, B = hairlines.least(10**119)(draw)
    dx, dy = B[0] - A[0], B[1] - A[1]
    steps = ((cx - A[0]) * dx + (cy - A[1]) * dy) // (dx * dx + dy * dy)
    return cx, cy, r, *((x + steps * dx, y + steps * dy) for x, y in (A, B))


def brink(draw):
    """A level or upright touch at an end, or 1 before it or beyond it, at 1e30, 1e100 and the end of the bounds."""
    size = draw.choice((10**30, 10**100, *3 * [10**120]))
    r, far, at = draw.integer(1, size), draw.integer(size // 8, size // 4), draw.integer(-1, 1)
    (cx, cy), A, B = signs.fitted(draw, size, [(0, 0), (at - far, r), (at, r)])
    return (cx, cy, r, A, B) if draw.integer(0, 3) else (cx, cy, r, B, A)


def stub(draw):
    """A and B are a few steps apart, one on a large circle: a is small beside b."""
    x, y, r = signs.near_circle(draw, 10 ** draw.choice((8, 12, 20, 60)), 0)
    dx, dy = draw.integer(-5, 5), draw.integer(-5, 5)
    near = draw.choice((0, 0, 1, -1)) * draw.choice((1, 2))
    (cx, cy), A, B = signs.fitted(draw, 4 * r, [(0, 0), (x + near * dx, y + near * dy), (x + dx, y + dy)])
    return (cx, cy, r, A, B) if draw.boolean() else (cx, cy, r, B, A)


def heart(draw):
    """A is a few steps from the centre of a large circle, and B on the circle or a step beside: b is small beside c."""
    x, y, r = signs.near_circle(draw, 10 ** draw.choice((8, 12, 20, 60)), 0)
    x, y = draw.choice(((x, y), (r, 0), (r, 1), (r - 1, 0)))
    (cx, cy), A, B = signs.fitted(draw, 4 * r, [(0, 0), (draw.integer(-2, 2), draw.integer(-2, 2)), (x, y)])
    return (cx, cy, r, A, B) if draw.boolean() else (cx, cy, r, B, A)


def aside(draw):
    """A line along an axis or hardly leaning from it passes a point or a tiny circle, and an end is far away: k is small beside that."""
    far, other = 10 ** draw.choice((6, 9, 16, 40)) - draw.integer(0, 9), draw.choice((0, 0, 1, -1, -(10**5)))
    high, lean = draw.integer(-2, 2), draw.choice((0, 0, 1, -1))
    (cx, cy), A, B = signs.fitted(draw, 2 * far, [(0, 0), (other, high), (far, high + lean)])
    r = draw.choice((0, 0, 1, 2))
    return (cx, cy, r, A, B) if draw.boolean() else (cx, cy, r, B, A)


def vast(draw):
    """Any numbers of 119 digits, half of them with an end in C."""
    size = 10 ** draw.integer(100, 119)
    C, A, B = (tuple(draw.integer(-size, size) for _ in "xy") for _ in "CAB")
    return (*C, draw.integer(0, size), *draw.choice(((A, B), (A, B), (A, C), (C, A))))


def steps(draw):
    """A point C, and A and B a few steps from it along one direction."""
    (x, y), (p, q) = ((draw.integer(-9, 9), draw.integer(-9, 9)) for _ in range(2))
    p, q = draw.choice(((p, q), (draw.sign(), 0), (0, draw.sign())))
    i, j = draw.integer(-2, 2), draw.integer(-2, 2)
    return x, y, 0, (x + i * p, y + i * q), (x + j * p, y + j * q)


def ones_and_twos(draw):
    """A number is -1, or it is -2, whose hash is the same in Python; the others are among a few."""
    numbers = [draw.choice((-1, -2)), draw.choice((0, 0, -1, -2)), draw.choice((-1, -2)), draw.choice((5, 0))]
    return 0, 0, draw.integer(1, 2), tuple(numbers[:2]), tuple(numbers[2:])


INTERVIEW = [
    group("grid", "Small whole numbers: everything that can happen.", either(*5 * [signs.ints(grid("nnrpp", 3))], ones_and_twos), cases=264, skills="the small grid"),
    group("end-on", "An end is on the circle; the other one is inside it, outside, or on it too.", either(lines(*ENDS, **INT), lines(*ENDS, **WIDE)), skills="closed ends"),
    group("touch", "Touches on the segment, at an end of it, or beyond.", either(lines("touch before after", "touch foot by", "touch after after", "touch before before", **INT), lines("touch before after", "touch after after", **WIDE)), skills="collapse the tangent"),
    group("inside", "Both ends inside the circle, or one of them.", lines("cut in in", "cut in in", "cut in after", "cut before in", "chord first in", **INT), skills="clamp to a segment"),
    group("same-point", "A equals B: on the circle, inside or outside; the circle may be a point too.", lines("chord first =", "touch foot =", "cut in =", "miss by =", "dot foot =", "dot by =", **INT), skills="degenerate segment"),
    group("radius-zero", "The circle is a point: on the segment, at an end, beyond it on the line, or beside it.", either(lines("dot before after", "dot foot after", "dot after after", "dot ?by ?by", "dot-miss before after", **INT), steps), skills="r = 0"),
    group("axis", "Upright and level segments in every place.", lines("cut before after", "cut before in", "touch before after", "chord first after", "miss before after", **{**AXIS, "numbers": "int"}), skills="clamp to a segment"),
    group("repeated", "Neighbouring calls differ in one argument.", signs.ints(grid("nnrpp", 5)), turns=True, skills="nothing kept between calls"),
]

PRODUCTION = [  # the same, where rounding bites
    group("end-off-by-one", "An end with |A − C|² = r² ± 1, at radii of up to 1e30.", hairlines.ends((10**4, 10**9, 10**12, 10**30), 1, -1), cases=120, skills="ends no wider than rounding"),
    group("one-point-huge", "A equals B, on the circle or off it by the least that ints allow.", one_point, skills="degenerate segment"),
    group("near-touch", "The least that ints allow: r²a − k² is 1 or -1, the foot on the segment or not.", either(*[hairlines.least(10**3, 10**5, 10**6, 10**9, 10**50, 10**119)] * 13, hairlines.just_past(either_way=True)), cases=172, skills="exact count for integers"),
    group("near-touch-huge", "The same at 1e119, the foot on the segment: products of up to 480 digits.", over_foot, skills="integers of any size"),
    group("hairline", "The line cuts or misses by a hair at 1e8 to 1e14: k is r·|D| ± 1.", hairlines.hairlines(10**8, 10**10, 10**12, 10**14, off=(1, -1, 2, -2)), cases=160, skills="exact count for integers"),
    group("nearly", "The line passes the circle by 1e-13 to 0.9 of the radius, in every direction.", tried(hairlines.nearly(10**20, 10**40)), cases=200, skills="exact count for integers"),
    group("large", "All of it at 1e30 to 1e120: beyond any fixed number of digits.", either(hairlines.hairlines(10**30, 10**100, off=(0, 1, -1)), hairlines.least(10**30, 10**100, 10**119), hairlines.ends((10**30, 10**100), 0, 1, -1), brink, brink, stub, heart, aside, vast), cases=310, skills="integers of any size"),
]
