"""Scenes of a circle and a line in doubles as they are: (cx, cy, r, ax, ay, bx, by), and the sign of
Δ = r²·|D|² − k² is what rounding hides.

    seven(lines("touch before after", **HUGE))     any scene of a circle and a line
    ulps(drawn, 1)                                 one number is some units in its last place off
    turned(drawn)                                  turned by an angle that no double holds
    odd_steps                                      (cx, cy, r, P)
    distant, brim                                  far away along one axis, and hardly beside it
    worst(drawn, 100)                              of so many draws the one that doubles get most wrong
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from fractions import Fraction
from math import cos, inf, isqrt, ldexp, nextafter, sin, ulp

from judge.data.draw import Draw, Rejected
from judge.geometry.level import Case, Scene, maker
from judge.geometry.pose import triple
from judge.geometry.whole import discriminant

_U = 2.0**-53
_ONE = 1 << 52  # ints that are doubles of 1 to 2 stand for so many of their units
_FINE = 1 << 240  # squares are taken to half of these digits
_TRIES, _PACE = 400, 648_887  # of a walk through numbers without a pattern


@maker
def seven(draw: Draw, drawn: Scene) -> Case:
    """The same with seven numbers, each of which a double holds."""
    cx, cy, r, A, B = drawn(draw)
    numbers = (cx, cy, r, *A, *B)
    if any(isinstance(x, int) and int(float(x)) != x for x in numbers):
        draw.reject()
    return numbers


@maker
def rounded(draw: Draw, drawn: Scene) -> Case:
    """Seven numbers, seen from the centre and rounded to doubles."""
    cx, cy, r, A, B = drawn(draw)
    return (
        0,
        0.0,
        float(r),
        *(float(x - c) for point in (A, B) for x, c in zip(point, (cx, cy), strict=True)),
    )


def plain(draw: Draw) -> Case:
    """Everything anywhere within 128: ints, or doubles of 46 bits."""
    if draw.integer(0, 2) == 0:
        return (
            *(draw.integer(-100, 100) for _ in "xy"),
            draw.integer(0, 100),
            *(draw.integer(-100, 100) for _ in "abcd"),
        )
    return easy(draw)


def easy(draw: Draw) -> Case:
    """Everything anywhere within 128: doubles of 46 bits."""
    top = (1 << 46) - 1
    return tuple(ldexp(draw.integer(0 if at == 2 else -top, top), -39) for at in range(7))


def huge(draw: Draw) -> Case:
    """Everything anywhere up to 2**64 to 2**97, in ints, in doubles of 53 bits, or in both."""
    up, kinds = draw.integer(12, 45), draw.choice(((int,), (float,), (int, float)))
    return tuple(draw.choice(kinds)(draw.integer(0 if at == 2 else -_ONE, _ONE) << up) for at in range(7))


def uneven(draw: Draw) -> Case:
    """Each number of a size of its own, 2**-50 to 2**90."""
    return tuple(
        ldexp(draw.integer(0 if at == 2 else -_ONE, _ONE), draw.integer(-100, 38)) for at in range(7)
    )


@maker
def ulps(draw: Draw, drawn: Scene, *steps: int) -> Case:
    """One of the numbers is so many units in its last place off."""
    numbers, at = [float(x) for x in drawn(draw)], draw.integer(0, 6)
    if not numbers[at]:
        draw.reject()
    sign, many = draw.sign(), draw.choice(steps)
    value = numbers[at]
    numbers[at] = value + sign * many * ulp(value) if many > 1 else nextafter(value, sign * inf)
    return tuple(numbers)


@maker
def turned(draw: Draw, drawn: Scene) -> Case:
    """The figure turned by an angle that no double holds, and rounded."""
    cx, cy, r, ax, ay, bx, by = drawn(draw)
    angle = draw.integer(1, 6_283) / 1000
    p, q = cos(angle), sin(angle)
    (cx, cy), A, B = ((p * x - q * y, q * x + p * y) for x, y in ((cx, cy), (ax, ay), (bx, by)))
    return cx, cy, float(r), *A, *B


@maker
def small_radius(draw: Draw, drawn: Scene) -> Case:
    """The radius is 0 or a part of the rounding of the other numbers."""
    cx, cy, _, *rest = drawn(draw)
    size = float(max(map(abs, (cx, cy, *rest))))
    return (cx, cy, draw.choice((0, 1, 1, 1)) * draw.integer(1, 12) * ulp(size) / 8, *rest)


def one_place(draw: Draw) -> Case:
    """A touch at one place of one of three circles, the other end off by a unit in its last place or not."""
    x, y, r = draw.choice(((3, 4, 5), (5, 12, 13), (7, 24, 25)))
    times = draw.sign() * draw.integer(1, 99) * 2 ** draw.integer(0, 30)
    b, at = [float(x - times * y), float(y + times * x)], draw.integer(0, 1)
    b[at] = draw.choice((b[at], nextafter(b[at], inf), nextafter(b[at], -inf)))
    return 0, 0.0, r, x, y, *b


def spread(draw: Draw, large: tuple[int, int] = (76, 92), little: tuple[int, int] = (-98, -80)) -> Case:
    """A line through a point of the circle, or next to it, with numbers of about 2**large and 2**little."""
    up, down = draw.integer(*large), draw.integer(*little)
    r, dx = (draw.integer(1, 99) << up for _ in range(2))
    dy, off = (draw.choice((0, 0, 1, -1)) * ldexp(draw.integer(1, 99), down) for _ in range(2))
    sides = draw.sign(), draw.sign()
    corners = [(sides[0] * float(x), sides[1] * float(y)) for x, y in ((0, -r), (0, off), (dx, dy or off))]
    if draw.boolean():
        corners = [(y, x) for x, y in corners]
    (cx, cy), A, B = corners
    return cx, cy, float(r), *A, *B


def vanishing(draw: Draw) -> Case:
    """k is nearly 3·2**-53 of dx·fy and dy·fx, |D|·r just below, and 0 in doubles; or it is the reverse."""
    step = 1 << draw.integer(22, 26)
    beyond = round(draw.choice((0.98, -2.03)) * _ONE / step) - step
    number = draw.integer(1 << 32, 1 << 33)
    for at in range(number, number + _TRIES * _PACE, _PACE):
        x, y = at + beyond, at
        if 0.485 < x * y % _ONE / _ONE < 0.5:
            return _crossed(draw, (_ONE + x, _ONE + y, _ONE + x + step, _ONE + y - step))
    return draw.reject()


def _crossed(draw: Draw, numbers: Sequence[int]) -> Case:
    """D and f of doubles (dx, fy, dy, fx) above 1, rounded so that k is too small."""
    dx, fy, dy, fx = (number / _ONE for number in numbers)
    off = -draw.integer(9900, 9999) / 10000 * _U
    wide, high = Fraction(dx) - Fraction(off), Fraction(dy) + Fraction(off)
    k = wide * (Fraction(fy) - Fraction(off)) - high * (Fraction(fx) + Fraction(off))
    square = wide * wide + high * high
    r = float(Fraction(isqrt(int(k * k / square * _FINE)), isqrt(_FINE)))
    while Fraction(r) ** 2 * square > k * k:
        r = nextafter(r, -inf)
    scale = 2.0 ** draw.choice((0, -40, 20, 52, 76))
    return tuple(scale * x for x in (-fx, -fy, r, off, -off, dx, dy))


@maker
def worst(draw: Draw, drawn: Scene, of: int) -> Case:
    """Of so many draws the one whose Δ in doubles is most off, as a part of `Discriminant.width`."""
    found = []
    for _ in range(of):
        with suppress(Rejected):
            found.append(drawn(draw))
    return max(found, key=_error) if found else draw.reject()


def _error(case: Case) -> float:
    cx, cy, r, ax, ay, bx, by = map(float, case)
    dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
    k = dx * fy - dy * fx
    found = r * r * (dx * dx + dy * dy) - k * k
    exact = discriminant(*case)
    return float(abs(Fraction(found) - exact.value) / (exact.width or 1))


def odd_steps(draw: Draw) -> Case:
    """(cx, cy, r, P): P is on the circle, and half-way to C is no double: all have 53 bits, and C is an odd
    number of them away, in x or in y.
    """
    (p, q, c), k = triple(draw, 65), draw.integer(0, 1 << draw.integer(0, 24)) * 2 + 1
    C = [draw.integer(_ONE + (1 << 33), 2 * _ONE - (1 << 33)) for _ in "xy"]
    P = C[0] + p * k * draw.sign(), C[1] + q * k * draw.sign()
    unit = 2.0 ** -draw.integer(23, 90)
    sides = unit * draw.sign(), unit * draw.sign()
    (cx, cy), place = (tuple(x * side for x, side in zip(point, sides, strict=True)) for point in (C, P))
    return cx, cy, c * k * unit, place


def distant(draw: Draw) -> Case:
    """A figure 2e7 to 2e9 times as far from the origin as it is large: a level line nearly touches
    the circle or hardly misses C, which may be its centre. One coordinate is large, the other one is small.
    """
    unit, x = 2.0 ** -draw.integer(24, 90), draw.integer(2**51, 2**53 - 2**28)
    size = draw.integer(2**22, 2**23) << draw.choice((0, 0, 0, 4))
    r, gap = draw.choice((0, 1, 1, 1)) * size, size * draw.integer(102, 190) / 10**9
    high = (r * draw.choice((0, 1, 1)) + gap * draw.choice((1, -1, 2) if r else (1,))) * draw.sign()
    a, b = draw.integer(-size, size), draw.integer(-size, size)
    if a == b:
        draw.reject()
    turn, side = draw.choice((1, 1, -1)), unit * draw.sign()
    C, A, B = (((x + at) * side, y * unit)[::turn] for at, y in ((0, 0.0), (a, high), (b, high)))
    return *C, r * unit, A, B


def brim(draw: Draw) -> Case:
    """A circle of a few units at the end of the bounds along one axis, and hardly beside the other one;
    a line across it.
    """
    x, y = 2**30 - draw.integer(2**10, 2**25), draw.integer(1, 8) / 4 * draw.sign()
    r, turn, up = draw.integer(1, 9), draw.choice((1, -1)), draw.integer(2, 300)
    across, lean = draw.integer(-r, r), draw.choice((0, 0, draw.integer(-9, 9)))
    A, B = (x + across, y + draw.integer(-300, up - 1)), (x + across + lean, y + up)
    return *(x, y)[::turn], r, *((A[::turn], B[::turn]) if draw.boolean() else (B[::turn], A[::turn]))
