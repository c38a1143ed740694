"""Scenes of many circles along a ray, and of solids made of discs.

    crowds("enter2 exit2 touch3~", **BIG)            (circles, O, D)
    solids("exit2 enter2", steps="difference", **BIG)   (circles, O, D, program)

A word says what happens at which slot along the ray. Slot 0 is its origin, slots 1 to 9 come after one
another; a word without a number takes the next one.

    enter, exit, touch, dot    that, at the slot; a dot is a circle of radius 0
    cut                        an enter at an irrational place after the slot
    speck, tiny                a touch far away, of 100 to 20,000 radii; a cut there, or as far as is clear
    around, about              a circle around the origin, or about it
    beside, behind             a circle beside the ray, or behind its origin
    copy, mirror               the last circle again, or put across the ray
    room                       a circle about the last one's centre, and two to nine times as large
    within                     a circle about the last one's centre, and smaller
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import chain
from math import hypot
from typing import Any

from judge.data.draw import Draw
from judge.geometry.crowd import DIFFERENCE, INTERSECTION, UNION
from judge.geometry.level import Case, Level, Nudge, Scene, Vocabulary, height, levelled, maker
from judge.geometry.pose import Atom, Length, Point, Vector
from judge.geometry.scenes.lines import sloping

_WORDS = Vocabulary.of(
    "what happens along a ray",
    "enter exit touch dot cut speck tiny around about beside behind touch-behind dot-behind"
    " copy mirror room within",
    numbered=True,
)
_STEPS = {
    "union": (UNION,),
    "intersection": (INTERSECTION,),
    "difference": (DIFFERENCE,),
    "any": (UNION, INTERSECTION, DIFFERENCE),
}
_SLOTS = 9
_TINY = (100, 20_000), (10**6, 5 * 10**6)  # radii that a tiny circle is away: near, or as far as is clear

Row = tuple[int, int, int]  # a level circle


def _level(draw: Draw, words: Sequence[str], size: int = 30, uneven: int = 0) -> Level:
    """The ray along the x axis from (0, 0), and the circles; one of them is `uneven` powers of two larger."""
    slots = [0]
    for _ in range(_SLOTS):
        slots.append(slots[-1] + draw.integer(size // 4 + 1, size))
    fresh = iter(range(1, _SLOTS + 1))
    large = draw.integer(0, len(words) - 1) if uneven else -1
    circles: list[Row] = []
    just_off = []
    for word in words:
        name = word.rstrip("~")
        kind = name.rstrip("0123456789")
        slot = name[len(kind) :]
        placed = kind not in ("copy", "mirror", "room", "within", "around", "about")
        at = slots[int(slot or next(fresh))] if placed else 0
        circles.append(_circle(draw, kind, at, size << (uneven if len(circles) == large else 0), circles))
        if word[-1] == "~":
            just_off.append((len(circles), 1 if kind in ("touch", "dot") else 0))
    atoms: list[Atom] = [Point([0, 0]), Vector([draw.integer(1, 9), 0])]
    for x, y, r in circles:
        atoms += [Point([x, y]), Length([r])]
    return atoms, [Nudge(atoms[2 * at], axis) for at, axis in just_off]


def _circle(draw: Draw, kind: str, at: int, size: int, before: Sequence[Row]) -> Row:
    side = draw.sign()
    if kind in ("copy", "mirror", "room", "within"):
        x, y, r = before[-1]
        if kind == "room":
            return x, y, r * draw.integer(2, 9)
        if kind == "within":
            return x, y, draw.integer(1, max(1, r - 1))
        return (x, -y, r) if kind == "mirror" else (x, y, r)
    if kind in ("enter", "exit"):
        r, y, half = height(draw, "chord", size)
        assert half is not None
        return at + half if kind == "enter" else at - half, y, r
    r = draw.integer(size // 4 + 1, size)
    across = draw.integer(1 - r, r - 1)
    rows: dict[str, Callable[[], Row]] = {
        "touch": lambda: (at, r * side, r),
        "touch-behind": lambda: (-at, r * side, r),
        "speck": lambda: (at + r * draw.integer(100, 20_000), r * side, r),
        "tiny": lambda: (at + r * draw.integer(*draw.choice(_TINY)), across // 4, r),
        "dot": lambda: (at, 0, 0),
        "dot-behind": lambda: (-at, 0, 0),
        "cut": lambda: (at + r, across, r),
        "around": lambda: (across // 3, draw.integer(1 - r, r - 1) // 3, r * draw.integer(2, 9)),
        "about": lambda: (0, 0, r * draw.integer(1, 9)),
        "beside": lambda: (at, (r + draw.integer(1, r)) * side, r),
        "behind": lambda: (-at - r - draw.integer(1, r), across, r),
    }
    return rows[kind]()


def circles_of(rest: Sequence[Any]) -> tuple[tuple[Any, ...], ...]:
    """The circles of posed centres and radii."""
    return tuple((*centre, r) for centre, r in zip(rest[::2], rest[1::2], strict=True))


_in_order = levelled(_level, lambda O, D, *rest: (circles_of(rest), O, D), _WORDS)


def crowds(*plans: str, **how: Any) -> Scene:
    """Circles and a ray; the circles are in any order."""
    return _mixed(_in_order(*plans, **how))


@maker
def _mixed(draw: Draw, drawn: Scene) -> Case:
    circles, O, D = drawn(draw)
    return mixed(draw, circles), O, D


@maker
def crowd_of(draw: Draw, /, *words: str, count: tuple[int, int], first: str, **how: Any) -> Case:
    """As many circles as `count` bounds, each of one of the words; those of `first` come besides."""
    plan = [
        f"{word}{draw.integer(1, _SLOTS)}" if word in ("cut", "beside", "behind", "enter", "exit") else word
        for word in (draw.choice(words) for _ in range(draw.integer(*count)))
    ]
    return crowds(" ".join([first, *plan]), **how)(draw)


@maker
def solids(draw: Draw, drawn: Scene, steps: str = "any", form: str = "row") -> Case:
    """A solid of the discs that `drawn` draws: (circles, O, D, program). Now and then one is not used.

    Args:
        steps: "union", "intersection", "difference" or "any" of them.
        form: "row" takes each disc together with all before it, "tree" in any nesting and some discs twice,
            "stack" puts all discs on the stack first, "holes" takes the union of all others from the first.
    """
    kinds = _STEPS[steps]
    circles, O, D = drawn(draw)
    discs = list(mixed(draw, range(len(circles))))
    if len(discs) > 1 and not draw.integer(0, 7):
        discs.pop()
    if form == "row":
        program = [discs[0], *chain(*((disc, draw.choice(kinds)) for disc in discs[1:]))]
    elif form == "stack":
        program = [*discs, *(draw.choice(kinds) for _ in discs[1:])]
    elif form == "holes":
        # the largest disc is the one with holes
        first = max(discs, key=lambda disc: circles[disc][2])
        others = [disc for disc in discs if disc != first]
        program = [first, *others, *[UNION] * (len(others) - 1), DIFFERENCE]
    else:
        program = _tree(draw, [*discs, *(draw.choice(discs) for _ in discs[::3])], kinds)
    return circles, O, D, tuple(program)


def _tree(draw: Draw, discs: Sequence[int], kinds: Sequence[int]) -> list[int]:
    if len(discs) == 1:
        return list(discs)
    at = draw.integer(1, len(discs) - 1)
    return [*_tree(draw, discs[:at], kinds), *_tree(draw, discs[at:], kinds), draw.choice(kinds)]


def mixed(draw: Draw, rows: Sequence[Any]) -> Case:
    """The rows in any order."""
    left, found = list(rows), []
    while left:
        found.append(left.pop(draw.integer(0, len(left) - 1)))
    return tuple(found)


@maker
def anywhere(
    draw: Draw, reach: int, count: tuple[int, int], radii: tuple[int, int] = (0, 0), light: bool = False
) -> Case:
    """Circles and a ray in whole numbers up to `reach`; with `light` a fourth argument, a point.

    `radii` bounds the radii, else they go up to `reach` too.
    """

    def pair() -> tuple[int, int]:
        return draw.integer(-reach, reach), draw.integer(-reach, reach)

    low, high = radii[0], radii[1] or reach
    circles = tuple((*pair(), draw.integer(low, high)) for _ in range(draw.integer(*count)))
    way = pair()
    if not any(way):
        draw.reject()
    return circles, pair(), way, *([pair()] if light else [])


@maker
def aligned(draw: Draw, reach: int, count: tuple[int, int]) -> Case:
    """Circles through the origin of a ray, with centres that are all on a level with it, or all upright."""
    (ox, oy), (dx, dy) = ((draw.integer(-reach, reach), draw.integer(-reach, reach)) for _ in range(2))
    radii = [draw.integer(1, reach) for _ in range(draw.integer(*count))]
    rows = [(ox + r * draw.sign(), oy, r) for r in radii]
    if not (dx or dy):
        draw.reject()
    if draw.boolean():
        return tuple(rows), (ox, oy), (dx, dy)
    return tuple((y, x, r) for x, y, r in rows), (oy, ox), (dy, dx)


def hardly(draw: Draw) -> Case:
    """Up to three circles whose centres are hardly above or beside a ray's origin, by 1e-6 to 1e-8 of how far
    away they are; the ray goes along an axis or a diagonal.
    """
    far = draw.integer(2**18, 2**20)
    hair = draw.integer(160, 255) * far * 2.0 ** -(8 + draw.choice((27, 27, 20)))
    x, y = draw.choice(((0, 0), (draw.integer(-3, 3) * far, draw.integer(-3, 3) * hair)))
    turn, scale = draw.choice((1, -1)), 2.0 ** draw.choice((7, draw.integer(-40, 7)))
    rows = []
    for _ in range(draw.integer(1, 3)):
        away, beside = draw.integer(1, 3) * draw.sign(), draw.integer(1, 3) * draw.sign()
        centre = (x + away * far) * scale, (y + beside * hair) * scale
        rows.append((*centre[::turn], abs(away) * far * draw.integer(50, 160) / 64 * scale))
    D = draw.choice(((0, 1), (0, -1), (0, 1), (0, -1), (draw.sign(), 0), (1, draw.sign())))
    return tuple(rows), (x * scale, y * scale)[::turn], D[::turn]


def apart(draw: Draw) -> Case:
    """Two circles along a ray: one begins 1e-7 to 1e-6 of the figure before or beyond the other one's end."""
    cx, cy, r, A, B = sloping(end="first")(draw)
    dx, dy = B[0] - A[0], B[1] - A[1]
    way = hypot(dx, dy)
    back = draw.integer(10, 150) / 100 * r / way
    return mixed(draw, ((cx, cy, r), (*B, way))), (A[0] - back * dx, A[1] - back * dy), (dx, dy)
