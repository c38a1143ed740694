"""Posing a level figure: turned, moved and scaled so that nothing is ever rounded.

A turn is a matrix M of integers with M·Mᵀ = n²: a Pythagorean triple in the plane, an integer quaternion in
space. It maps whole points to whole points and multiplies every length by n, so what touches still touches. A
number is a double if its significant bits, without trailing zeros, are at most 53; a pose that needs more is
given up.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence
from itertools import permutations
from math import gcd, isqrt
from operator import mul
from typing import Any

from judge.data.draw import Draw

Matrix = Sequence[Sequence[int]]
_DOUBLE = 53  # significant bits of a double
_BOUND = 30  # coordinates stay within ±2**30
_UNIT = -99  # and the unit is at least 2**-99, which is above 1e-30
_LEAST = -94  # the power of two of the largest number of a figure whose numbers are as small as they may be
_TINIEST = 1e-30
_FAR = 50  # bits that a split point has in common with the first one

# How large the figure is before the pose, how it is turned, by how many bits moved, scaled to which powers
# of two. Beside each, how many bits of a double its numbers use.
PLAIN = {"size": 30, "turn": "small", "move": 6}  # 13
AXIS = {"size": 30, "turn": "axis", "move": 6}  # 8
BIG = {"size": 2**20, "turn": "any", "move": 30, "shift": (0, -20)}  # 34: squares round
HUGE = {"size": 2**38, "turn": "any", "move": 50, "shift": -22}  # 52: a cross product rounds
SPLIT = {
    "size": 2**40,
    "uneven": 9,
    "turn": "any",
    "move": "split",
    "shift": -32,
}  # differences of 63: all rounds
NEAR = {"size": 2**12, "turn": "any", "shift": (0, -20, -40)}  # 40
TINY = {"size": 2**12, "turn": "any", "shift": (-99, -75, "least")}  # 40
FAR = {"size": 40, "turn": "small", "shift": (0, -20)}  # 32
OFFSET = {"size": 50, "turn": "small", "move": 52, "shift": -20}  # 53
LEVEL = {**OFFSET, "move": "level"}
STEEP = {"size": 2**10, "turn": "steep", "move": 6, "shift": (0, -20)}  # 51
TILTED = {"size": 30, "turn": "axis", "move": 4, "tilt": (20, 44)}  # 52: steeper than a turn, no touch
ASKEW = {**TILTED, "tilt": (9, 11)}  # 19: along an axis but for 2e-5 to 1e-3
DECIMALS = {"size": 99, "turn": "axis", "move": 6, "decimals": True}


class Point(list[int]):
    """A point: turned and moved."""


class Vector(list[int]):
    """A vector: turned, never moved."""


class Length(list[int]):
    """A length, in a list of one: multiplied by the turn's n."""


Atom = Point | Vector | Length

_TRIPLES = sorted(
    (
        (m * m - n * n, 2 * m * n, m * m + n * n)
        for m in range(2, 48)
        for n in range(1, m)
        if gcd(m, n) == 1 and (m - n) % 2
    ),
    key=lambda triple: triple[2],
)  # 461 of them, hypotenuses from 5 to 4,418


def triple(draw: Draw, most: int) -> tuple[int, int, int]:
    """(p, q, c) with p² + q² = c² and 5 <= c <= most, in either order of p and q."""
    p, q, c = _TRIPLES[draw.integer(0, bisect_right(_TRIPLES, most, key=lambda each: each[2]) - 1)]
    return (q, p, c) if draw.boolean() else (p, q, c)


def posed(
    draw: Draw,
    atoms: Sequence[Atom],
    *,
    turn: str = "any",
    move: int | str = 0,
    shift: int | Sequence[int | str] = 0,
    stretch: int | Sequence[int] = 0,
    numbers: str = "any",
    decimals: bool = False,
    tilt: Sequence[int] = (),
) -> list[Any]:
    """The figure as the caller's numbers: a tuple for a point or vector, one number for a length.

    Args:
        turn: "axis" (the symmetries of the axes), "small" (triples to 65), "any" (to 4,418), "steep", or
            "diagonal" in space.
        move: by whole numbers of so many bits. Or "level": by 52 bits along one axis. Or "split": the second
            point takes the last bits of the way from the first one, which takes all others, so that their
            difference is no double.
        shift: the power of two that scales all, or "least" for numbers just above 1e-30; of several one is
            taken.
        stretch: another one for vectors.
        numbers: "int", "float", "mixed" or any of these, where a number is whole.
        decimals: whether the numbers are tenths or hundredths, each the double that is nearest.
        tilt: bounds of the power of two by which the figure is finer than a step that the last vector, or
            the last point where there is none, makes across the level: what it touched is then no touch.
    """
    finer = draw.integer(*tilt) if tilt else 0
    if tilt:
        tilted = (_those(Vector, atoms, atoms) or _those(Point, atoms, atoms))[-1]
        for each in atoms:
            each[:] = [n << finer for n in each]
        tilted[1] += draw.integer(1, 9) * draw.sign()
    matrix, norm = _turned(draw, len(_those(Point, atoms, atoms)[0]), turn)
    turned = [
        [norm * each[0]] if isinstance(each, Length) else [_dot(row, each) for row in matrix]
        for each in atoms
    ]
    centre = _centre(draw, _those(Point, atoms, turned), move)
    whole = [
        [x + (m << finer) for x, m in zip(row, centre, strict=True)] if isinstance(each, Point) else row
        for row, each in zip(turned, atoms, strict=True)
    ]
    if decimals:
        return _named(atoms, _decimals(draw, atoms, turned))
    if max([_significant(x) for row in whole for x in row]) > _DOUBLE:
        draw.reject()
    size = _one(draw, shift)
    exponent = _LEAST - _bits(whole) if size == "least" else min(size - finer, _BOUND - _bits(whole))
    if exponent < _UNIT:
        own = _those((Length, Point), atoms, whole)
        if any(0 < abs(x) * 2.0**exponent < _TINIEST for row in own for x in row):
            draw.reject()
    kind = draw.choice(("int", "float", "mixed")) if numbers == "any" else numbers
    number = _binary(draw, kind, exponent)
    most = _BOUND - _bits(_those(Vector, atoms, whole))
    longer = max(_UNIT, min(exponent + _one(draw, stretch), most))
    along = _binary(draw, kind, longer)
    return _named(
        atoms,
        [
            [(along if isinstance(each, Vector) else number)(x) for x in row]
            for row, each in zip(whole, atoms, strict=True)
        ],
    )


def _those(kind: Any, atoms: Sequence[Atom], rows: Sequence[Any]) -> list[Any]:
    """The rows of the atoms of a kind."""
    return [row for row, each in zip(rows, atoms, strict=True) if isinstance(each, kind)]


def _named(atoms: Sequence[Atom], values: Sequence[Sequence[Any]]) -> list[Any]:
    """A number for a length, a tuple for a point or vector."""
    return [
        row[0] if isinstance(each, Length) else tuple(row) for each, row in zip(atoms, values, strict=True)
    ]


def _turned(draw: Draw, dimension: int, turn: str) -> tuple[Matrix, int]:
    """(M, n) with M·Mᵀ = n²."""
    if dimension == 3:
        return _turned_in_space(draw, turn)
    if turn == "axis":
        p, q, n = draw.choice(((1, 0, 1), (0, 1, 1)))
    elif turn == "steep":
        m = 1 << draw.integer(1, 20)
        p, q, n = m * m - 1, 2 * m, m * m + 1
        p, q = (q, p) if draw.boolean() else (p, q)
    else:
        p, q, n = triple(draw, 65 if turn == "small" else 4_418)
    p, q, mirror = p * draw.sign(), q * draw.sign(), draw.sign()
    return ((p, -q * mirror), (q, p * mirror)), n


def _turned_in_space(draw: Draw, turn: str) -> tuple[Matrix, int]:
    """The rotation of an integer quaternion, or one of the 48 symmetries of the axes."""
    if turn == "axis":
        order = draw.choice(list(permutations(range(3))))
        return tuple(tuple(draw.sign() if j == i else 0 for j in range(3)) for i in order), 1
    most = 3 if turn == "small" else 40
    a, b, c, d = (draw.integer(-most, most) for _ in range(4))
    if turn == "diagonal":
        a, b, c, d = 0, 11, 4 * draw.sign(), 4 * draw.sign()  # x to one of (89, ±88, ±88)/153
    n = a * a + b * b + c * c + d * d
    if not n:
        draw.reject()
    return (
        (a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)),
        (2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)),
        (2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d),
    ), n


def _centre(draw: Draw, points: Sequence[Sequence[int]], move: int | str) -> list[int]:
    """By how much the points are moved."""
    if isinstance(move, int):
        return [draw.integer(-(2**move), 2**move) if move else 0 for _ in points[0]]
    if move == "level":
        axis, way = draw.integer(0, len(points[0]) - 1), draw.integer(2**40, 2**52) * draw.sign()
        return [way if at == axis else 0 for at in range(len(points[0]))]
    first, second = points[:2]
    ways = [y - x for x, y in zip(first, second, strict=True)]
    return [way % 2 ** max(0, way.bit_length() - _FAR) - y for way, y in zip(ways, second, strict=True)]


def _binary(draw: Draw, kind: str, shift: int) -> Callable[[int], int | float]:
    up, down = 1 << max(0, shift), 1 << max(0, -shift)

    def number(x: int) -> int | float:
        whole = x % down == 0 and (kind == "int" or (kind == "mixed" and draw.boolean()))
        return x * up // down if whole else x * up / down  # exact: the bits were counted

    return number


def _decimals(draw: Draw, atoms: Sequence[Atom], turned: Sequence[Sequence[int]]) -> list[list[int | float]]:
    """The figure in tenths or hundredths, each the double that is nearest.

    What touches still does where the numbers that must be equal are one double. So the centre is at a whole
    number along an axis only if every difference from it is exact, and else at 0.
    """
    per = draw.choice((10, 100))
    exact = [[x // per if x % per == 0 else x / per for x in row] for row in turned]
    places = _those(Point, atoms, exact)
    for axis in range(len(places[0])):
        centre = draw.integer(-9, 9)
        if all(x + centre - centre == x and x + centre - x == centre for x in [row[axis] for row in places]):
            for row in places:
                row[axis] += centre  # exact: the sum gives both of its terms back
    return exact


def _one(draw: Draw, options: int | Sequence[Any]) -> Any:
    return options if isinstance(options, int) else draw.choice(options)


def _significant(x: int) -> int:
    return x.bit_length() - (x & -x).bit_length() + 1 if x else 0


def _bits(rows: Sequence[Sequence[int]]) -> int:
    return max([x.bit_length() for row in rows for x in row], default=0)


def _dot(u: Sequence[int], v: Sequence[int]) -> int:
    return sum(map(mul, u, v))


def root_up(square: int) -> int:
    """√square, rounded up."""
    return isqrt(square - 1) + 1 if square > 0 else 0
