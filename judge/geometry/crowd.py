"""Many circles and one ray: where it meets them, in order, and what of it is inside a solid of discs.

D is the same for all circles, so hits are told apart by their u = −b ± √Δ alone, t being u/a. Values to 64
bits sort them. Neighbours are then decided exactly, which is enough: what is equal is so throughout, and a
sum of clear ways is clear.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain
from math import isqrt
from typing import NamedTuple

from judge.exact.surd import integers, make
from judge.geometry.quadratic import ORIGIN, Number, Point, Quadratic
from judge.geometry.sure import BITS, DecisionWords, Sure
from judge.problem.declare import InvalidCase
from judge.values.answers import Real

Circle = tuple[Number, Number, Number]

UNION, INTERSECTION, DIFFERENCE = -1, -2, -3
PLACES = DecisionWords(
    "Two places on the ray are almost the same",
    "They must be exactly the same, or at least 1e-7·e apart.",
    ("two hits are apart", "two hits are at exactly the same place", "two hits are apart"),
)


class Hit(NamedTuple):
    """A common point of the ray and a circle: -1 where it enters, 0 where it touches, 1 where it leaves."""

    circle: int
    which: int
    near: int = 0  # u in units of 2**-64, off by less than one


class Crowd:
    """Circles (C, r) and the ray O + t·D; e is the largest of all r and all |C − O|∞.

    Raises InvalidCase where D is (0, 0); ValueError for nan, infinities and a radius below 0.

    Attributes:
        circles: each circle and the ray.
        sure: what decides, at the size e of them all.
        points: `others` as seen from O, which e reaches to as well.
    """

    def __init__(self, circles: Sequence[Circle], O: Point, D: Point, *others: Point) -> None:
        (ox, oy, dx, dy, *rest), shift = integers(*O, *D, *chain(*others), *chain(*circles))
        places, flat = rest[: 2 * len(others)], rest[2 * len(others) :]
        self.points = [(x - ox, y - oy) for x, y in zip(places[::2], places[1::2], strict=True)]
        seen = [(ox - x, oy - y, r) for x, y, r in zip(flat[::3], flat[1::3], flat[2::3], strict=True)]
        if not dx and not dy:
            raise InvalidCase("D is (0, 0). There must be a ray.")
        self.sure = Sure(max(map(abs, chain(*seen, *self.points))))
        self.circles = [
            Quadratic((x, y), (dx, dy), r, self.sure, shift=shift, ends=ORIGIN) for x, y, r in seen
        ]

    def hits(self) -> list[Hit]:
        """The hits with t >= 0 in order of t, those at one place in any order.

        Of a circle that the ray leaves behind only O is decided: outside of it, and getting no nearer to its
        centre, the ray cannot meet it.
        """
        found = []
        for index, circle in enumerate(self.circles):
            if circle.side() > 0 and circle.b >= 0:
                continue
            for which in circle.meets():
                root = which * isqrt(circle.delta << 2 * BITS) if which else 0
                if circle.beside(which, 0) >= 0:
                    found.append(Hit(index, which, (-circle.b << BITS) + root))
        return sorted(found, key=lambda hit: hit.near)

    def places(self) -> list[list[Hit]]:
        """The same, those at one place together."""
        found: list[list[Hit]] = []
        for hit in self.hits():
            last = found[-1][0] if found else None
            if last and not apart(self.circles[last.circle], last.which, self.circles[hit.circle], hit.which):
                found[-1].append(hit)
            else:
                found.append([hit])
        return found

    def time(self, hit: Hit) -> Real:
        """The hit's t; its unit is e/|D|∞."""
        return self.circles[hit.circle].time(hit.which)

    def spans(self, program: Sequence[int]) -> list[tuple[Real, Real]]:
        """The longest intervals of t >= 0 inside the solid, in order. InvalidCase for what is no program."""
        fault = program_fault(program, len(self.circles))
        if fault:
            raise InvalidCase(fault)
        places = self.places()
        enters = {hit.circle for hit in chain(*places) if hit.which < 0}
        leaves = {hit.circle for hit in chain(*places) if hit.which > 0}
        held = [index in leaves - enters for index in range(len(self.circles))]
        cuts = [(self.time(hits[0]), hits) for hits in places]
        if not places or self.circles[places[0][0].circle].beside(
            places[0][0].which, 0
        ):  # the ray begins in the middle of a piece
            cuts.insert(0, (Real(make(0, 0, 0, 1), self.circles[0].time_unit()), []))
        found, start = [], None
        for time, hits in cuts:
            for hit in hits:
                if hit.which:
                    held[hit.circle] = hit.which < 0
            now = inside(program, held)
            if now and start is None:
                start = time
            elif start is not None and not now:
                found.append((start, time))
                start = None
        return found


def apart(p: Quadratic, one: int, q: Quadratic, other: int) -> int:
    """Whether two common points, of circles and the same ray, are at different places."""
    return p.sure.sign(p.b - q.b, other, q.delta, -one, p.delta, per=p.a, what=PLACES)


def program_fault(program: Sequence[int], discs: int) -> str | None:
    """Why these steps are no program for so many discs; None where they are one.

    A program is postfix: n >= 0 is the disc n, the three operations take the two solids before them.
    """
    depth = 0
    for step in program:
        if step >= discs or step < DIFFERENCE:
            return f"The program names {step}, and there are {discs} discs."
        if step < 0 and depth < 2:
            return f"The program's {step} has less than two solids before it."
        depth += 1 if step >= 0 else -1
    return None if depth == 1 else f"The program leaves {depth} solids, not one."


def inside(program: Sequence[int], held: Sequence[bool]) -> bool:
    """Whether a place is in the solid; `held` says which discs it is in."""
    stack: list[bool] = []
    for step in program:
        if step >= 0:
            stack.append(held[step])
            continue
        other, one = stack.pop(), stack.pop()
        stack.append(one or other if step == UNION else one and (other == (step == INTERSECTION)))
    return stack[0]
