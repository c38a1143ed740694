"""When a moving disc first touches another one, or a wall: the least t from 0 to 1.

Seen from the second disc, the centre of the first is a point that runs towards a circle of radius r + s. For
a wall AB it runs towards the wall fattened by r: two sides, and a cap around each end. With D the way,
W = B − A and k = W × (P0 − A) it is r beside the line AB at t = (−k ± r·√(W·W))/(W × D).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import NamedTuple

from judge.exact.signs import root_sign, two_root_sign
from judge.exact.surd import integers, make
from judge.geometry.quadratic import Number, Point, Quadratic
from judge.geometry.sure import DecisionWords, Sides, Sure
from judge.problem.declare import InvalidCase
from judge.values.answers import Real

LEAST_MOTION = 1_000  # the way is 0, or at least size/LEAST_MOTION
LEAST_WALL = 10_000  # a wall is a point, or at least size/LEAST_WALL long
LEAST_SINE = 10_000  # of way and wall the sine is 0, or at least 1/LEAST_SINE


def _words(almost: str, length: str, wanted: str, sides: Sides) -> DecisionWords:
    must = f"{length} must equal {wanted} exactly, or differ from it by at least 1e-7·e."
    return DecisionWords(almost, must, sides)


def _at(almost: str, length: str, wanted: str, who: str) -> tuple[DecisionWords, DecisionWords]:
    """The words of whether discs, or a disc and the wall, touch at t = 0, and at t = 1."""
    start, end = (
        _words(
            f"{almost} at t = {t}",
            length,
            wanted,
            (f"{who} overlap at t = {t}", f"{who} touch exactly at t = {t}", f"{who} are apart at t = {t}"),
        )
        for t in (0, 1)
    )
    return start, end


_DISCS, _DISC = "The distance of the centres", "The distance of the disc's centre from the wall"
_END = "The distance of A and of B from the line of the way"


class Discs(Quadratic):
    """One disc as seen from the other."""

    touch = _words(
        "The discs almost graze each other",
        f"Without end both ways the least of {_DISCS.lower()}",
        "r + s",
        ("the discs overlap on the way", "the discs graze exactly", "the discs pass each other"),
    )
    ends = _at("The discs almost touch", _DISCS, "r + s", "the discs")


class Cap(Quadratic):
    """The disc as seen from an end of the wall."""

    touch = _words(
        "The disc almost grazes an end of the wall",
        _END,
        "r",
        ("the disc overlaps an end", "the disc grazes an end exactly", "the disc passes an end"),
    )
    ends = _at("The disc almost touches the wall", _DISC, "r", "disc and wall")


def balls_meeting(P0: Point, P1: Point, r: Number, Q0: Point, Q1: Point, s: Number) -> Real | None:
    """The least t from 0 to 1 at which two discs touch or overlap; its unit is e/|D|∞.

    D = (P1 − P0) − (Q1 − Q0), e = max(r + s, |P1 − P0|∞, |Q0 − P0|∞, |Q1 − P0|∞). Raises InvalidCase where
    they are nearly in touch at the start, and if they are apart then and come closer, where they are at the
    end or nearly graze, and where D is less than e/1000 but not 0; ValueError for nan, infinities, r < 0.
    """
    (ax, ay, bx, by, gx, gy, hx, hy, one, other), shift = integers(*P0, *P1, *Q0, *Q1, r, s)
    if one < 0 or other < 0:
        raise ValueError("a radius is negative")
    way = (bx - ax) - (hx - gx), (by - ay) - (hy - gy)
    spans = (bx - ax, by - ay, gx - ax, gy - ay, hx - ax, hy - ay)
    sure = Sure(max(one + other, *map(abs, spans)))
    line = Discs((ax - gx, ay - gy), way, one + other, sure, shift=shift)
    sure.least(line.a, LEAST_MOTION, "The way of one disc as seen from the other")
    if line.side() <= 0:
        return _start(line)
    if line.b >= 0:
        return None
    line.side(1)
    first = next(iter(line.meets()), None)
    return None if first is None or line.beside(first, 1) > 0 else line.time(first)


class _Moment(NamedTuple):
    """t = (p + q·√d)/m with m > 0."""

    p: int
    q: int
    d: int
    m: int

    def beside(self, t: int) -> int:
        return root_sign(self.p - t * self.m, self.q, self.d)

    def before(self, other: _Moment) -> bool:
        p = self.p * other.m - other.p * self.m
        return two_root_sign(p, self.q * other.m, self.d, -other.q * self.m, other.d) < 0


def wall_meeting(P0: Point, P1: Point, r: Number, A: Point, B: Point) -> Real | None:
    """The least t from 0 to 1 at which a disc touches or overlaps the wall AB; its unit is e/|D|∞.

    D = P1 − P0, e = max(r, |A − P0|∞, |A − P1|∞, |B − P0|∞, |B − P1|∞). Raises InvalidCase where it is nearly
    in touch at the start, and if it is clear of the wall then, where it is at the end, where A or B is nearly
    r away from the line of the way, where the wall or the way is too short, and where they are nearly
    parallel; ValueError for nan, infinities and r < 0.
    """
    (px, py, qx, qy, radius, ax, ay, bx, by), shift = integers(*P0, *P1, r, *A, *B)
    d, w, f = (qx - px, qy - py), (bx - ax, by - ay), (px - ax, py - ay)
    g = px - bx, py - by
    sure = Sure(max(radius, *map(abs, (*f, *g, f[0] + d[0], f[1] + d[1], g[0] + d[0], g[1] + d[1]))))
    caps = [Cap(each, d, radius, sure, shift=shift) for each in (f, g)]
    way, wall = caps[0].a, w[0] * w[0] + w[1] * w[1]
    sure.least(way, LEAST_MOTION, "The way")
    sure.least(wall, LEAST_WALL, "The wall")
    turn = w[0] * d[1] - w[1] * d[0]
    if turn and turn * turn * LEAST_SINE**2 < wall * way:
        raise InvalidCase("The way and the wall are almost parallel. The sine must be 0, or at least 1e-4.")

    def apart(t: int) -> int:
        """Whether the disc is in touch with the wall at t, 0 or 1."""
        x, y = f[0] + t * d[0], f[1] + t * d[1]
        foot, k = x * w[0] + y * w[1], w[0] * y - w[1] * x
        if 0 < foot < wall:
            return sure.distance(k * k, radius, wall, what=Cap.ends[t])
        return caps[foot > 0 and wall > 0].side(t)

    if apart(0) <= 0:
        return _start(caps[0])
    if not way:
        return None
    apart(1)
    found = []
    for cap in caps:
        for which in cap.meets()[:1]:
            found.append(_Moment(-cap.b, which, cap.delta if which else 0, cap.a))
    if turn:
        found += _sides(f, d, w, radius)
    ahead = [moment for moment in found if moment.beside(0) > 0]
    if not ahead:
        return None
    first = ahead[0]
    for moment in ahead[1:]:
        first = moment if moment.before(first) else first
    if first.beside(1) > 0:
        return None
    return Real(make(*first), caps[0].time_unit())


def _sides(f: Sequence[int], d: Sequence[int], w: Sequence[int], r: int) -> Iterator[_Moment]:
    """When the centre is r beside the wall, between its ends."""
    foot, pace, wall = f[0] * w[0] + f[1] * w[1], d[0] * w[0] + d[1] * w[1], w[0] * w[0] + w[1] * w[1]
    k, turn = w[0] * f[1] - w[1] * f[0], w[0] * d[1] - w[1] * d[0]
    sign = 1 if turn > 0 else -1
    for side in (-r, r):
        p, q, m = -k * sign, side * sign, turn * sign
        along = foot * m + pace * p  # of the centre from A, times m·|W|
        if root_sign(along, pace * q, wall) >= 0 >= root_sign(along - wall * m, pace * q, wall):
            yield _Moment(p, q, wall, m)


def _start(line: Quadratic) -> Real:
    return Real(make(0, 0, 0, 1), line.time_unit() if line.a else Fraction(0))
